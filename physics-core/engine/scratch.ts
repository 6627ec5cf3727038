import type { Ammo } from './ammo.js';

/**
 * Argument objects shared by all calls into Ammo, made once and never freed: Ammo copies its arguments,
 * and an object made per call would have to be destroyed per call.
 */
export class Scratch {
  readonly #vectors: Ammo['btVector3']['prototype'][];
  readonly #quaternion: Ammo['btQuaternion']['prototype'];
  readonly #transforms: Ammo['btTransform']['prototype'][];

  constructor(ammo: Ammo) {
    this.#vectors = [0, 1, 2].map(() => new ammo.btVector3(0, 0, 0));
    this.#quaternion = new ammo.btQuaternion(0, 0, 0, 1);
    this.#transforms = [0, 1].map(() => new ammo.btTransform());
  }

  /** `slot` 0 to 2: a call that takes two vectors takes two slots. */
  vector(x: number, y: number, z: number, slot = 0): Ammo['btVector3']['prototype'] {
    const vector = this.#vectors[slot]!;
    vector.setValue(x, y, z);
    return vector;
  }

  /** x, y, z, w. */
  quaternion(q: ArrayLike<number>): Ammo['btQuaternion']['prototype'] {
    this.#quaternion.setValue(q[0]!, q[1]!, q[2]!, q[3]!);
    return this.#quaternion;
  }

  /** Position `p` and quaternion `q` (x, y, z, w). `slot` 0 or 1. */
  transform(
    p: ArrayLike<number>,
    q: ArrayLike<number>,
    slot = 0,
  ): Ammo['btTransform']['prototype'] {
    const transform = this.#transforms[slot]!;
    transform.setIdentity();
    transform.setOrigin(this.vector(p[0]!, p[1]!, p[2]!));
    transform.setRotation(this.quaternion(q));
    return transform;
  }
}
