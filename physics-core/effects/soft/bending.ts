import type { Strand } from '../../solver/ropes/strand.js';
import { SURE } from './tolerances.js';

const bend = new Float64Array(3);

/**
 * What bends a line takes to do so: where two links meet at an angle, three points are pushed until they lie on a line again.
 * The energy of that is ½ EI κ² for each metre, with κ the change of direction from link to link. Forces are those of the
 * places where the step begins (symplectic Euler: nothing is lost), which waves shorter than a step can't follow.
 */
export class Bending {
  readonly #strand: Strand;

  constructor(strand: Strand) {
    this.#strand = strand;
  }

  /** The stiffest that steps of `dt` seconds follow, N m². */
  most(dt: number): number {
    const { masses, lengths, points } = this.#strand;
    let most = Infinity;
    for (let i = 1; i < points - 1; i++) {
      const length = (lengths[i - 1]! + lengths[i]!) / 2;
      most = Math.min(most, (masses[i]! * length ** 3) / (4 * dt * dt));
    }
    return SURE * most;
  }

  /** Adds what `stiffness`, N m², does in such a time to the velocities without pulls. */
  push(stiffness: number, time: number): void {
    const { masses, lengths, ways, free, points } = this.#strand;
    for (let i = 1; i < points - 1; i++) {
      const before = lengths[i - 1]!;
      const after = lengths[i]!;
      const length = (before + after) / 2;
      const share = (stiffness * time) / length ** 2;
      const j = 3 * i;
      for (let k = 0; k < 3; k++)
        bend[k] = share * (ways[j + k]! / after - ways[j - 3 + k]! / before);
      for (let k = 0; k < 3; k++) {
        free[j - 3 + k]! -= bend[k]! / masses[i - 1]!;
        free[j + k]! += (2 * bend[k]!) / masses[i]!;
        free[j + 3 + k]! -= bend[k]! / masses[i + 1]!;
      }
    }
  }
}
