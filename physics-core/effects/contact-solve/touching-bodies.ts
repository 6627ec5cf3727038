import { grownInt } from '../../base/grown.js';
import { PointerNumbers } from '../../base/pointer-numbers.js';
import type { Ammo } from '../../engine/ammo.js';
import { originOf } from '../../engine/body-heap.js';
import { inverseMassOf } from '../../engine/body-state.js';
import { readLoad, readVelocity } from '../../engine/heap.js';
import { displace, readInertia, writeVelocity } from '../../engine/solver-body.js';
import { SIZE } from '../../solver/matrix/block-cholesky.js';
import { SolveBodies } from '../../solver/solve-bodies.js';

/** The bodies that are in touch in a step, as Bullet has them. */
export class TouchingBodies extends SolveBodies {
  pointers = new Int32Array(16);
  readonly #ammo: Ammo;
  readonly #load = new Float64Array(SIZE);
  readonly #numbers = new PointerNumbers();

  constructor(ammo: Ammo) {
    super();
    this.#ammo = ammo;
  }

  override begin(): void {
    super.begin();
    this.#numbers.clear();
  }

  /** The number of a body, by its pointer; -1: it does not move. A new one is read later. */
  numberOf(pointer: number): number {
    if (inverseMassOf(this.#ammo, pointer) === 0) return -1;
    const i = this.#numbers.numberOf(pointer);
    if (i < this.count) return i;
    this.add();
    this.pointers[i] = pointer;
    return i;
  }

  protected override grow(room: number): void {
    super.grow(room);
    this.pointers = grownInt(this.pointers, room);
  }

  /** What a step of `dt` seconds begins with. False: numbers that are none. */
  read(i: number, dt: number): boolean {
    const ammo = this.#ammo;
    const pointer = this.pointers[i]!;
    const at = i * SIZE;
    this.masses[i] = 1 / inverseMassOf(ammo, pointer);
    readInertia(ammo, pointer, this.inertias, this.inverseInertias, 9 * i);
    readVelocity(ammo, pointer, this.velocities, at);
    readLoad(ammo, pointer, this.#load, 0);
    let sum = this.masses[i]!;
    for (let k = 0; k < 3; k++) {
      this.free[at + k] = this.velocities[at + k]! + (dt / this.masses[i]!) * this.#load[k]!;
      let spin = 0;
      for (let l = 0; l < 3; l++)
        spin += this.inverseInertias[i * 9 + 3 * k + l]! * this.#load[3 + l]!;
      this.free[at + 3 + k] = this.velocities[at + 3 + k]! + dt * spin;
      sum += this.free[at + k]! + this.free[at + 3 + k]!;
    }
    return Number.isFinite(sum);
  }

  /** One number of its centre of mass, metres. */
  originOf(body: number, k: number): number {
    return originOf(this.#ammo, this.pointers[body]!, k);
  }

  /** Its velocity goes to Bullet. */
  writeVelocity(body: number): void {
    writeVelocity(this.#ammo, this.pointers[body]!, this.velocities, body * SIZE);
  }

  /** By how much it was pushed apart (`change`), before the step moves it on. */
  writePlace(body: number): void {
    displace(this.#ammo, this.pointers[body]!, this.change, body * SIZE);
  }
}
