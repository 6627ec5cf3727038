import type { Binding } from '../nodes/binding.js';
import { inOrder } from './order.js';
import type { PageWorld } from '../nodes/surroundings.js';

/**
 * Collidables that no body owns and no list names: they are obstacles in the world of a CollisionCollection or
 * CollisionSpace that lists everything (`*`), the nearest one's.
 */
export class Unlisted {
  readonly #everything = new Map<Binding, PageWorld>();
  readonly #asked = new Set<Binding>();

  /** It lists everything in this world, or no longer. */
  note(collection: Binding, world: PageWorld | null): void {
    if (world === (this.#everything.get(collection) ?? null)) return;
    if (world) this.#everything.set(collection, world);
    else this.#everything.delete(collection);
    const asked = [...this.#asked];
    this.#asked.clear();
    for (const collidable of asked) collidable.dirty();
  }

  /** The first in the collidable's own scope, else in those around it, else in any. */
  worldOf(collidable: Binding): PageWorld | undefined {
    this.#asked.add(collidable);
    if (this.#everything.size === 0) return undefined;
    const all = inOrder([...this.#everything.keys()]);
    let found: Binding | undefined;
    for (let scope = collidable.scope; scope && !found; scope = scope.parent)
      found = all.find((collection) => collection.scope === scope);
    return this.#everything.get(found ?? all[0]);
  }

  /** It has left. */
  forget(binding: Binding): void {
    this.#asked.delete(binding);
    this.note(binding, null);
  }
}
