import { dot3 } from '../base/flat-math.js';
import { grown } from '../base/grown.js';
import { SIZE } from './matrix/block-cholesky.js';

/** The bodies of a step that contacts move, six numbers each: linear, then angular. */
export class SolveBodies {
  count = 0;
  masses = new Float64Array(16);
  /** World frame, 3 × 3. */
  inertias = new Float64Array(16 * 9);
  inverseInertias = new Float64Array(16 * 9);
  /** As they would be without contacts, and as they are found, m/s and rad/s. */
  free = new Float64Array(16 * SIZE);
  velocities = new Float64Array(16 * SIZE);
  change = new Float64Array(16 * SIZE);
  momentum = new Float64Array(16 * SIZE);

  begin(): void {
    this.count = 0;
  }

  /** Room for one more; returns its number. */
  protected add(): number {
    if (this.count === this.masses.length) this.grow(2 * this.count);
    return this.count++;
  }

  protected grow(room: number): void {
    this.masses = grown(this.masses, room);
    this.inertias = grown(this.inertias, 9 * room);
    this.inverseInertias = grown(this.inverseInertias, 9 * room);
    this.free = grown(this.free, SIZE * room);
    this.velocities = grown(this.velocities, SIZE * room);
    this.change = grown(this.change, SIZE * room);
    this.momentum = grown(this.momentum, SIZE * room);
  }

  /** M (v - free), into `momentum`. */
  gradient(bodies: readonly number[]): void {
    const { velocities: v, free, momentum, inertias, masses } = this;
    for (const body of bodies) {
      const i = body * SIZE;
      const mass = masses[body]!;
      momentum[i] = mass * (v[i]! - free[i]!);
      momentum[i + 1] = mass * (v[i + 1]! - free[i + 1]!);
      momentum[i + 2] = mass * (v[i + 2]! - free[i + 2]!);
      const x = v[i + 3]! - free[i + 3]!;
      const y = v[i + 4]! - free[i + 4]!;
      const z = v[i + 5]! - free[i + 5]!;
      momentum[i + 3] = turned(inertias, 9 * body, x, y, z);
      momentum[i + 4] = turned(inertias, 9 * body + 3, x, y, z);
      momentum[i + 5] = turned(inertias, 9 * body + 6, x, y, z);
    }
  }

  /** The greatest speed that `momentum` stands for, of a body by itself, m/s or rad/s. */
  fastest(bodies: readonly number[]): number {
    const { momentum, inverseInertias, masses } = this;
    let most = 0;
    for (const body of bodies) {
      const i = body * SIZE;
      const mass = masses[body]!;
      const x = momentum[i + 3]!;
      const y = momentum[i + 4]!;
      const z = momentum[i + 5]!;
      most = Math.max(
        most,
        Math.abs(momentum[i]! / mass),
        Math.abs(momentum[i + 1]! / mass),
        Math.abs(momentum[i + 2]! / mass),
        Math.abs(turned(inverseInertias, 9 * body, x, y, z)),
        Math.abs(turned(inverseInertias, 9 * body + 3, x, y, z)),
        Math.abs(turned(inverseInertias, 9 * body + 6, x, y, z)),
      );
    }
    return most;
  }

  /** The greatest linear speed of all, m/s. */
  fastestOf(bodies: readonly number[]): number {
    const v = this.velocities;
    let most = 0;
    for (const body of bodies) {
      const i = body * SIZE;
      most = Math.max(most, dot3(v, i, v, i));
    }
    return Math.sqrt(most);
  }

  /** The greatest speed or spin of all without contacts, m/s or rad/s. */
  pace(bodies: readonly number[]): number {
    const v = this.free;
    let most = 0;
    for (const body of bodies)
      for (let i = body * SIZE; i < (body + 1) * SIZE; i += 3)
        most = Math.max(most, dot3(v, i, v, i));
    return Math.sqrt(most);
  }

  /** Of motion at these velocities, J. */
  energyOf(bodies: readonly number[], v: Float64Array): number {
    let sum = 0;
    for (const body of bodies) {
      const at = body * SIZE;
      sum += this.masses[body]! * dot3(v, at, v, at);
      for (let k = 0; k < 3; k++)
        sum += v[at + 3 + k]! * dot3(this.inertias, 9 * body + 3 * k, v, at + 3);
    }
    return sum / 2;
  }

  /** Whether it is turned by more than this where it was pushed apart, radians. */
  isTurned(body: number, least: number): boolean {
    const at = body * SIZE + 3;
    return dot3(this.change, at, this.change, at) > least ** 2;
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
    const { change, inertias, masses } = this;
    let sum = 0;
    for (const body of bodies) {
      const mass = masses[body]!;
      const i = body * SIZE;
      const x = change[i + 3]!;
      const y = change[i + 4]!;
      const z = change[i + 5]!;
      for (let k = 0; k < 3; k++) {
        const m = 9 * body + 3 * k;
        const turn = change[i + 3 + k]!;
        sum += mass * change[i + k]! * change[i + k]!;
        sum += turn * inertias[m]! * x;
        sum += turn * inertias[m + 1]! * y;
        sum += turn * inertias[m + 2]! * z;
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
}

/** A row of a 3 × 3 matrix by a vector. */
const turned = (m: Float64Array, row: number, x: number, y: number, z: number): number =>
  0 + m[row]! * x + m[row + 1]! * y + m[row + 2]! * z;
