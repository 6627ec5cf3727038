import type { Binding } from '../nodes/binding.js';

/** Which nodes read which elements that are no physics nodes themselves: Shapes, geometry, Coordinates, Transforms. */
export class Readers {
  readonly #byElement = new Map<Element, Set<Binding>>();
  readonly #byBinding = new Map<Binding, Set<Element>>();

  add(element: Element, reader: Binding): void {
    const readers = this.#byElement.get(element) ?? new Set();
    this.#byElement.set(element, readers.add(reader));
    const elements = this.#byBinding.get(reader) ?? new Set();
    this.#byBinding.set(reader, elements.add(element));
  }

  of(element: Element): Iterable<Binding> {
    return this.#byElement.get(element) ?? [];
  }

  forget(reader: Binding): void {
    for (const element of this.#byBinding.get(reader) ?? []) {
      const readers = this.#byElement.get(element);
      if (readers?.delete(reader) && readers.size === 0) this.#byElement.delete(element);
    }
    this.#byBinding.delete(reader);
  }
}
