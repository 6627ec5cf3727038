import type { Ammo } from './ammo.js';
import { HeapExhausted } from './exhausted.js';

/**
 * Owns Ammo objects: who makes one hands it over in the same expression, and only `dispose` destroys, newest first.
 * What a getter returns is borrowed and never comes here.
 */
export class Owner {
  readonly #ammo: Ammo;
  readonly #owned: object[] = [];

  constructor(ammo: Ammo) {
    this.#ammo = ammo;
  }

  own<T extends object>(object: T): T {
    // Ammo hands out a null pointer, and Bullet would write there.
    if (this.#ammo.getPointer(object) === 0) throw new HeapExhausted();
    this.#owned.push(object);
    return object;
  }

  dispose(): void {
    for (let object = this.#owned.pop(); object; object = this.#owned.pop()) {
      this.#ammo.destroy(object);
    }
  }
}
