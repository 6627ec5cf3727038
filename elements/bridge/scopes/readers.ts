import { Sets } from '../base/sets.js';
import type { Watcher } from './names.js';

/** Which nodes read which elements that are no physics nodes themselves: Shapes, geometry, Coordinates, Transforms. */
export class Readers {
  readonly #byElement = new Sets<Element, Watcher>();
  readonly #byReader = new Sets<Watcher, Element>();

  add(element: Element, reader: Watcher): void {
    this.#byElement.add(element, reader);
    this.#byReader.add(reader, element);
  }

  of(element: Element): Iterable<Watcher> {
    return this.#byElement.get(element) ?? [];
  }

  forget(reader: Watcher): void {
    for (const element of this.#byReader.get(reader) ?? []) this.#byElement.delete(element, reader);
    this.#byReader.deleteAll(reader);
  }
}
