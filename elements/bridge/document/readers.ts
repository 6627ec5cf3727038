import type { Binding } from '../nodes/binding.js';
import { Sets } from '../base/sets.js';

/** Which nodes read which elements that are no physics nodes themselves: Shapes, geometry, Coordinates, Transforms. */
export class Readers {
  readonly #byElement = new Sets<Element, Binding>();
  readonly #byBinding = new Sets<Binding, Element>();

  add(element: Element, reader: Binding): void {
    this.#byElement.add(element, reader);
    this.#byBinding.add(reader, element);
  }

  of(element: Element): Iterable<Binding> {
    return this.#byElement.get(element) ?? [];
  }

  forget(reader: Binding): void {
    for (const element of this.#byBinding.get(reader) ?? [])
      this.#byElement.delete(element, reader);
    this.#byBinding.deleteAll(reader);
  }
}
