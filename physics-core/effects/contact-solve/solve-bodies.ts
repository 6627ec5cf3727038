import { grown, grownInt } from '../../base/grown.js';
import type { Ammo } from '../../engine/ammo.js';
import { BODY } from '../../engine/offsets.js';
import { SIZE } from './sparse-cholesky.js';

/** Moment of what can't be turned, kg m². */
const UNTURNABLE = 1e12;

/** The bodies of a step that contacts move, six numbers each: linear, then angular. */
export class SolveBodies {
  count = 0;
  pointers = new Int32Array(16);
  masses = new Float64Array(16);
  /** World frame, 3 × 3. */
  inertias = new Float64Array(16 * 9);
  inverseInertias = new Float64Array(16 * 9);
  /** As they would be without contacts, and as they are found, m/s and rad/s. */
  free = new Float64Array(16 * SIZE);
  velocities = new Float64Array(16 * SIZE);
  change = new Float64Array(16 * SIZE);
  momentum = new Float64Array(16 * SIZE);
  readonly #ammo: Ammo;
  readonly #numbers = new Map<number, number>();

  constructor(ammo: Ammo) {
    this.#ammo = ammo;
  }

  begin(): void {
    this.count = 0;
    this.#numbers.clear();
  }

  /** The number of a body, by its pointer; -1: it does not move. A new one is read later. */
  numberOf(pointer: number): number {
    if (this.#ammo.HEAPF32[(pointer + BODY.inverseMass) >> 2] === 0) return -1;
    const known = this.#numbers.get(pointer);
    if (known !== undefined) return known;
    const i = this.count++;
    this.#numbers.set(pointer, i);
    if (i === this.pointers.length) this.#grow();
    this.pointers[i] = pointer;
    return i;
  }

  #grow(): void {
    const room = 2 * this.pointers.length;
    this.pointers = grownInt(this.pointers, room);
    this.masses = grown(this.masses, room);
    this.inertias = grown(this.inertias, 9 * room);
    this.inverseInertias = grown(this.inverseInertias, 9 * room);
    this.free = grown(this.free, SIZE * room);
    this.velocities = grown(this.velocities, SIZE * room);
    this.change = grown(this.change, SIZE * room);
    this.momentum = grown(this.momentum, SIZE * room);
  }

  /** What a step of `dt` seconds begins with. False: numbers that are none. */
  read(i: number, dt: number): boolean {
    const f = this.#ammo.HEAPF32;
    const pointer = this.pointers[i]!;
    const inverseMass = f[(pointer + BODY.inverseMass) >> 2]!;
    this.masses[i] = 1 / inverseMass;
    this.#readInertia(i, pointer);
    const v = (pointer + BODY.linearVelocity) >> 2;
    const w = (pointer + BODY.angularVelocity) >> 2;
    const force = (pointer + BODY.totalForce) >> 2;
    const torque = (pointer + BODY.totalTorque) >> 2;
    const at = i * SIZE;
    const turn = this.inverseInertias;
    for (let k = 0; k < 3; k++) {
      this.free[at + k] = f[v + k]! + dt * inverseMass * f[force + k]!;
      let spin = f[w + k]!;
      for (let l = 0; l < 3; l++) spin += dt * turn[i * 9 + 3 * k + l]! * f[torque + l]!;
      this.free[at + 3 + k] = spin;
    }
    for (let k = 0; k < 3; k++) {
      this.velocities[at + k] = f[v + k]!;
      this.velocities[at + 3 + k] = f[w + k]!;
    }
    let sum = this.masses[i]!;
    for (let k = 0; k < SIZE; k++) sum += this.free[at + k]!;
    return Number.isFinite(sum);
  }

  #readInertia(i: number, pointer: number): void {
    const f = this.#ammo.HEAPF32;
    const basis = (pointer + BODY.basis) >> 2;
    const local = (pointer + BODY.inverseInertiaLocal) >> 2;
    for (let p = 0; p < 3; p++)
      for (let q = 0; q < 3; q++) {
        let inertia = 0;
        let inverse = 0;
        for (let k = 0; k < 3; k++) {
          const square = f[basis + 4 * p + k]! * f[basis + 4 * q + k]!;
          const share = f[local + k]!;
          inverse += square * share;
          inertia += square * (share > 0 ? 1 / share : UNTURNABLE);
        }
        this.inertias[i * 9 + 3 * p + q] = inertia;
        this.inverseInertias[i * 9 + 3 * p + q] = inverse;
      }
  }

  /** M (v - free), into `momentum`. */
  gradient(bodies: readonly number[]): void {
    for (const body of bodies) {
      const at = body * SIZE;
      for (let k = 0; k < 3; k++) {
        this.momentum[at + k] =
          this.masses[body]! * (this.velocities[at + k]! - this.free[at + k]!);
        let spin = 0;
        for (let l = 0; l < 3; l++)
          spin +=
            this.inertias[9 * body + 3 * k + l]! *
            (this.velocities[at + 3 + l]! - this.free[at + 3 + l]!);
        this.momentum[at + 3 + k] = spin;
      }
    }
  }

  /** The greatest speed that `momentum` stands for, of a body by itself, m/s or rad/s. */
  fastest(bodies: readonly number[]): number {
    let most = 0;
    for (const body of bodies) {
      const at = body * SIZE;
      for (let k = 0; k < 3; k++) {
        let spin = 0;
        for (let l = 0; l < 3; l++)
          spin += this.inverseInertias[9 * body + 3 * k + l]! * this.momentum[at + 3 + l]!;
        most = Math.max(
          most,
          Math.abs(this.momentum[at + k]! / this.masses[body]!),
          Math.abs(spin),
        );
      }
    }
    return most;
  }

  /** changeᵀ momentum */
  along(bodies: readonly number[]): number {
    let sum = 0;
    for (const body of bodies)
      for (let k = body * SIZE; k < (body + 1) * SIZE; k++)
        sum += this.change[k]! * this.momentum[k]!;
    return sum;
  }

  /** changeᵀ M change */
  square(bodies: readonly number[]): number {
    let sum = 0;
    for (const body of bodies) {
      const at = body * SIZE;
      for (let k = 0; k < 3; k++) {
        sum += this.masses[body]! * this.change[at + k]! ** 2;
        for (let l = 0; l < 3; l++)
          sum +=
            this.change[at + 3 + k]! *
            this.inertias[9 * body + 3 * k + l]! *
            this.change[at + 3 + l]!;
      }
    }
    return sum;
  }

  /** M onto a 6 × 6 block. */
  addMass(body: number, block: Float64Array, at: number): void {
    for (let k = 0; k < 3; k++) {
      block[at + k * SIZE + k]! += this.masses[body]!;
      for (let l = 0; l < 3; l++)
        block[at + (3 + k) * SIZE + 3 + l]! += this.inertias[9 * body + 3 * k + l]!;
    }
  }

  /** Its velocity, and by how much it was pushed apart (`change`), go to Bullet. */
  write(body: number): void {
    const f = this.#ammo.HEAPF32;
    const pointer = this.pointers[body]!;
    const { velocities, change } = this;
    const v = (pointer + BODY.linearVelocity) >> 2;
    const w = (pointer + BODY.angularVelocity) >> 2;
    const o = (pointer + BODY.origin) >> 2;
    const at = body * SIZE;
    for (let k = 0; k < 3; k++) {
      f[v + k] = velocities[at + k]!;
      f[w + k] = velocities[at + 3 + k]!;
      f[o + k]! += change[at + k]!;
    }
    this.#turn(pointer, change[at + 3]!, change[at + 4]!, change[at + 5]!);
  }

  /** By a small angle, radians; Bullet makes a rotation of it again when the body moves on. */
  #turn(pointer: number, x: number, y: number, z: number): void {
    const f = this.#ammo.HEAPF32;
    const basis = (pointer + BODY.basis) >> 2;
    for (let k = basis; k < basis + 3; k++) {
      const [p, q, r] = [f[k]!, f[k + 4]!, f[k + 8]!];
      f[k] = p + y * r - z * q;
      f[k + 4] = q + z * p - x * r;
      f[k + 8] = r + x * q - y * p;
    }
  }
}
