import type { Body } from '../../dynamics/body.js';
import { add6, copy6, INERTIA, SIDE } from '../../solver/joints/blocks.js';
import type { Component } from '../../solver/joints/forest.js';
import type { RowSystem } from '../../solver/joints/row-system.js';
import type { JointedBodies } from './jointed-bodies.js';

/** Where, behind the mass, what resists turning about each axis stands. */
const TURNS = [1, 3, 6];

/** How bodies of a component go in a step, and by what is given them: six numbers of each. */
export interface Yields {
  /** If nobody gives them anything. */
  readonly free: Float64Array;
  /** Velocity for an impulse: a full symmetric matrix. */
  readonly compliance: Float64Array;
  /** Of `free`, of the whole component: twice the energy. */
  energy: number;
  /** Whether no edit had torn it: round ways count then. */
  whole: boolean;
  /** Theirs in the row system. */
  readonly numbers: number[];
}

/** Asks joints how they let their bodies go: what unit impulses do, by factors that the row system has. */
export class YieldingBodies {
  readonly #system: RowSystem;
  readonly #bodies: JointedBodies;

  constructor(system: RowSystem, bodies: JointedBodies) {
    this.#system = system;
    this.#bodies = bodies;
  }

  /** Of a component that was solved just now. False: one of the bodies is none of its. */
  find(component: Component, bodies: readonly Body[], to: Yields): boolean {
    const { numbers } = to;
    numbers.length = 0;
    for (const body of bodies) numbers.push(this.#numberOf(component, body));
    if (numbers.includes(-1)) return false;
    const { velocity } = this.#system;
    for (let n = 0; n < numbers.length; n++) copy6(to.free, SIDE * n, velocity, SIDE * numbers[n]!);
    to.energy = this.#energyOf(component);
    for (let c = 0; c < SIDE * numbers.length; c++) this.#push(component, c, to);
    evenOut(to.compliance, SIDE * numbers.length);
    return true;
  }

  /** What else gives them momentum, `share` times, and how all of it goes then. */
  give(component: Component, { numbers }: Yields, impulse: Float64Array, share: 1 | -1): void {
    const { momentum } = this.#system;
    for (let n = 0; n < numbers.length; n++)
      add6(momentum, SIDE * numbers[n]!, impulse, SIDE * n, share);
    this.#system.again(component);
  }

  /** Of a component that was solved anew. Returns by how much they go otherwise. */
  findFree({ free, numbers }: Yields): number {
    const { velocity } = this.#system;
    let most = 0;
    for (let n = 0; n < numbers.length; n++)
      for (let k = 0; k < SIDE; k++) {
        const v = velocity[SIDE * numbers[n]! + k]!;
        most = Math.max(most, Math.abs(v - free[SIDE * n + k]!));
        free[SIDE * n + k] = v;
      }
    return most;
  }

  #numberOf({ bodies }: Component, body: Body): number {
    for (const i of bodies) if (this.#bodies.bodies[i] === body) return i;
    return -1;
  }

  /** One number of one body's momentum is more by what gives it a velocity of 1 if no joint holds it. */
  #push(component: Component, c: number, { free, compliance, numbers }: Yields): void {
    const { momentum, velocity } = this.#system;
    const width = SIDE * numbers.length;
    const body = numbers[Math.floor(c / SIDE)]!;
    const at = SIDE * body + (c % SIDE);
    const impulse = this.#resists(body, c % SIDE);
    const before = momentum[at]!;
    momentum[at] = before + impulse;
    this.#system.again(component);
    momentum[at] = before;
    for (let n = 0; n < numbers.length; n++)
      for (let k = 0; k < SIDE; k++) {
        const r = SIDE * n + k;
        compliance[r * width + c] = (velocity[SIDE * numbers[n]! + k]! - free[r]!) / impulse;
      }
  }

  #resists(body: number, k: number): number {
    const at = INERTIA * body;
    return this.#system.inertia[k < 3 ? at : at + TURNS[k - 3]!]!;
  }

  #energyOf({ bodies }: Component): number {
    const { inertia, velocity } = this.#system;
    let sum = 0;
    for (const i of bodies) {
      const n = INERTIA * i;
      const v = SIDE * i;
      const x = velocity[v + 3]!;
      const y = velocity[v + 4]!;
      const z = velocity[v + 5]!;
      for (let k = v; k < v + 3; k++) sum += inertia[n]! * velocity[k]! ** 2;
      sum += inertia[n + 1]! * x * x + inertia[n + 3]! * y * y + inertia[n + 6]! * z * z;
      sum += 2 * (inertia[n + 2]! * x * y + inertia[n + 4]! * x * z + inertia[n + 5]! * y * z);
    }
    return sum;
  }
}

/** What one does to the other the other does to it: rounding aside. */
function evenOut(m: Float64Array, width: number): void {
  for (let r = 0; r < width; r++)
    for (let c = 0; c < r; c++)
      m[r * width + c] = m[c * width + r] = (m[r * width + c]! + m[c * width + r]!) / 2;
}
