import { invertSymmetric, makeSemidefinite } from '../../base/symmetric.js';
import type { SolveBodies } from '../solve-bodies.js';
import { SIZE } from '../matrix/block-cholesky.js';

/** Numbers of a 3 × 3. */
const SQUARE = 9;

/**
 * Masses for one round of a search along curved paths. What pulls at the end of an arm resists its turning, as it does a
 * pendulum's: the second derivative of the joints, which straight rows know nothing of. It holds bodies to the velocities
 * that the round begins with, not to those without contacts, and so is nothing any more once the rounds have found their end.
 */
export class ProximalMasses {
  readonly #bodies: SolveBodies;
  /** As they were, by body. */
  #masses = new Float64Array(0);
  #inertias = new Float64Array(0);
  #inverses = new Float64Array(0);
  #free = new Float64Array(0);
  /** What pulls resist turning by, N s m per rad. */
  #stiffness = new Float64Array(0);
  readonly #momentum = new Float64Array(3);

  constructor(bodies: SolveBodies) {
    this.#bodies = bodies;
  }

  /** A round begins: nothing pulls so far. */
  begin(bodies: readonly number[]): void {
    const { masses, inertias, inverseInertias, free } = this.#bodies;
    if (this.#masses.length < masses.length) this.#grow(masses.length);
    for (const body of bodies) {
      this.#masses[body] = masses[body]!;
      const from = body * SQUARE;
      for (let k = from; k < from + SQUARE; k++) {
        this.#inertias[k] = inertias[k]!;
        this.#inverses[k] = inverseInertias[k]!;
        this.#stiffness[k] = 0;
      }
      for (let k = body * SIZE; k < (body + 1) * SIZE; k++) this.#free[k] = free[k]!;
    }
  }

  #grow(room: number): void {
    this.#masses = new Float64Array(room);
    this.#inertias = new Float64Array(SQUARE * room);
    this.#inverses = new Float64Array(SQUARE * room);
    this.#stiffness = new Float64Array(SQUARE * room);
    this.#free = new Float64Array(SIZE * room);
  }

  /** An impulse of `sign` times `pull` acts on a body at the end of an arm from its centre of mass. */
  pull(body: number, arm: Float64Array, pull: Float64Array, sign: 1 | -1): void {
    const k = this.#stiffness;
    const at = body * SQUARE;
    const along = arm[0]! * pull[0]! + arm[1]! * pull[1]! + arm[2]! * pull[2]!;
    for (let x = 0; x < 3; x++) {
      k[at + 4 * x]! += sign * along;
      for (let y = 0; y < 3; y++)
        k[at + 3 * x + y]! -= (sign / 2) * (pull[x]! * arm[y]! + pull[y]! * arm[x]!);
    }
  }

  /** All pulls are known, of a step of `dt` seconds. `give`: how many times its mass holds each body back besides. */
  apply(bodies: readonly number[], dt: number, give: number): void {
    for (const body of bodies) {
      // What pushes would turn it over: that is not for one round.
      makeSemidefinite(this.#stiffness, body * SQUARE);
      this.#applyTo(body, dt, give);
    }
  }

  #applyTo(body: number, dt: number, give: number): void {
    const { masses, inertias, inverseInertias, free, velocities } = this.#bodies;
    const k = this.#stiffness;
    const at = body * SQUARE;
    const v = body * SIZE;
    const w = v + 3;
    masses[body]! *= 1 + give;
    for (let x = v; x < w; x++) free[x] = (free[x]! + give * velocities[x]!) / (1 + give);
    const m = this.#momentum.fill(0);
    for (let j = 0; j < SQUARE; j++) {
      const back = give * inertias[at + j]! + dt * k[at + j]!;
      m[(j / 3) | 0]! += inertias[at + j]! * free[w + (j % 3)]! + back * velocities[w + (j % 3)]!;
      inertias[at + j]! += back;
    }
    invertSymmetric(inertias, inverseInertias, at);
    for (let x = 0; x < 3; x++) {
      free[w + x] = 0;
      for (let y = 0; y < 3; y++) free[w + x]! += inverseInertias[at + 3 * x + y]! * m[y]!;
    }
  }

  /** The round is over: masses are what they were. */
  end(bodies: readonly number[]): void {
    const { masses, inertias, inverseInertias, free } = this.#bodies;
    for (const body of bodies) {
      masses[body] = this.#masses[body]!;
      const from = body * SQUARE;
      for (let k = from; k < from + SQUARE; k++) {
        inertias[k] = this.#inertias[k]!;
        inverseInertias[k] = this.#inverses[k]!;
      }
      for (let k = body * SIZE; k < (body + 1) * SIZE; k++) free[k] = this.#free[k]!;
    }
  }
}
