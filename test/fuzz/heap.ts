import { Owner } from '../../physics-core/engine/owner.js';
import type { Engine } from '../../physics-core/inside.js';

/** Counts the objects on the heap that somebody owns, from when it is made on. */
export class OwnedObjects {
  readonly #live = new Set<number>();
  readonly #made = new Map<number, string>();

  constructor({ ammo }: Engine) {
    const live = this.#live;
    const made = this.#made;
    const { own } = Owner.prototype;
    Owner.prototype.own = function <T extends object>(this: Owner, object: T): T {
      own.call(this, object);
      live.add(ammo.getPointer(object));
      made.set(ammo.getPointer(object), object.constructor.name);
      return object;
    };
    const { destroy } = ammo;
    ammo.destroy = (object: object): void => {
      live.delete(ammo.getPointer(object));
      destroy.call(ammo, object);
    };
  }

  get count(): number {
    return this.#live.size;
  }

  /** Names of those made since there were so many. */
  since(count: number): string {
    return [...this.#live]
      .slice(count)
      .map((pointer) => this.#made.get(pointer))
      .join(', ');
  }
}
