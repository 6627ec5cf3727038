import { cos, sin } from '../../base/exact/index.js';
import { SIDE } from '../../solver/joints/blocks.js';
import type { Component, Edge } from '../../solver/joints/forest.js';
import type { JointedBodies } from './jointed-bodies.js';
import { MATRIX, writeMatrix } from '../../base/matrix.js';
import type { RowSystem } from '../../solver/joints/row-system.js';

const QUATERNION = 4;

/** Where the velocities found will take the bodies in the step. */
export class NextPoses {
  readonly #system: RowSystem;
  readonly #bodies: JointedBodies;
  /** The turn of the step. */
  #step = new Float64Array(0);
  /** As `JointedBodies` has them, of bodies that joints hold by rows. */
  place = new Float64Array(0);
  turn = new Float64Array(0);
  #hasRows = new Uint8Array(0);
  readonly #matrix = new Float64Array(MATRIX);

  constructor(system: RowSystem, bodies: JointedBodies) {
    this.#system = system;
    this.#bodies = bodies;
  }

  take(bodies: number, edges: readonly Edge[], components: readonly Component[]): void {
    if (this.#hasRows.length < bodies) this.#grow(bodies * 2);
    this.#hasRows.fill(0);
    for (const { rows } of components) {
      for (const row of rows) {
        const { a, b } = edges[row]!;
        if (a >= 0) this.#hasRows[a] = 1;
        if (b >= 0) this.#hasRows[b] = 1;
      }
    }
  }

  #grow(room: number): void {
    this.#step = new Float64Array(room * QUATERNION);
    this.place = new Float64Array(room * 3);
    this.turn = new Float64Array(room * MATRIX);
    this.#hasRows = new Uint8Array(room);
  }

  /** As the step will move and turn them. */
  predict({ bodies }: Component, dt: number): void {
    for (const i of bodies) {
      this.#turnOn(i, dt);
      if (this.#hasRows[i]) this.#moveOn(i, dt);
    }
  }

  #turnOn(i: number, dt: number): void {
    const { velocity } = this.#system;
    const q = i * QUATERNION;
    const x = velocity[i * SIDE + 3]!;
    const y = velocity[i * SIDE + 4]!;
    const z = velocity[i * SIDE + 5]!;
    const speed = Math.sqrt(x * x + y * y + z * z);
    const half = (speed * dt) / 2;
    const s = speed > 1e-12 ? sin(half) / speed : dt / 2;
    this.#step[q] = x * s;
    this.#step[q + 1] = y * s;
    this.#step[q + 2] = z * s;
    this.#step[q + 3] = cos(half);
  }

  #moveOn(i: number, dt: number): void {
    const { velocity } = this.#system;
    const { place, turn } = this.#bodies;
    const m = this.#matrix;
    for (let x = 0; x < 3; x++)
      this.place[i * 3 + x] = place[i * 3 + x]! + dt * velocity[i * SIDE + x]!;
    writeMatrix(m, 0, this.#step, i * QUATERNION);
    const o = i * MATRIX;
    for (let c = o; c < o + 3; c++) {
      const x = turn[c]!;
      const y = turn[c + 3]!;
      const z = turn[c + 6]!;
      this.turn[c] = m[0]! * x + m[1]! * y + m[2]! * z;
      this.turn[c + 3] = m[3]! * x + m[4]! * y + m[5]! * z;
      this.turn[c + 6] = m[6]! * x + m[7]! * y + m[8]! * z;
    }
  }

  /** `out` += `sign` times the way that the point at the end of `arms[at]` will go. */
  addDisplacement(
    i: number,
    arms: Float64Array,
    at: number,
    dt: number,
    sign: 1 | -1,
    out: Float64Array,
  ): void {
    const { velocity } = this.#system;
    const v = i * SIDE;
    const q = i * QUATERNION;
    const a = this.#step[q]!;
    const b = this.#step[q + 1]!;
    const c = this.#step[q + 2]!;
    const w = this.#step[q + 3]!;
    const x = arms[at]!;
    const y = arms[at + 1]!;
    const z = arms[at + 2]!;
    const tx = 2 * (b * z - c * y);
    const ty = 2 * (c * x - a * z);
    const tz = 2 * (a * y - b * x);
    out[0]! += sign * (dt * velocity[v]! + w * tx + b * tz - c * ty);
    out[1]! += sign * (dt * velocity[v + 1]! + w * ty + c * tx - a * tz);
    out[2]! += sign * (dt * velocity[v + 2]! + w * tz + a * ty - b * tx);
  }
}
