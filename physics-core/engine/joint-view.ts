import { quaternionOfRows, type Pose } from '../base/math.js';
import type { Ammo } from './ammo.js';
import { SIX_DOF } from './offsets.js';

/** What Bullet has of a btGeneric6DofConstraint, by its pointer */
export class JointView {
  readonly #ammo: Ammo;

  constructor(ammo: Ammo) {
    this.#ammo = ammo;
  }

  /** The frame from the centre of mass of Bullet's A or B. */
  frame(constraint: number, side: 'A' | 'B'): Pose {
    const heap = this.#ammo.HEAPF32;
    const m = (constraint + (side === 'A' ? SIX_DOF.frameA : SIX_DOF.frameB)) >> 2;
    const at = (i: number): number => heap[m + i]!;
    return {
      p: [at(12), at(13), at(14)],
      q: quaternionOfRows(at(0), at(1), at(2), at(4), at(5), at(6), at(8), at(9), at(10)),
    };
  }

  /** Lower and upper bound of a row, metres or radians: distances of B against A, angles of A against B. */
  bounds(constraint: number, row: number): [number, number] {
    const heap = this.#ammo.HEAPF32;
    if (row >= 3) {
      const at = (constraint + SIX_DOF.angularLower + (row - 3) * SIX_DOF.angularSize) >> 2;
      return [heap[at]!, heap[at + 1]!];
    }
    const low = SIX_DOF.linearLower;
    const high = SIX_DOF.linearUpper;
    return [heap[((constraint + low) >> 2) + row]!, heap[((constraint + high) >> 2) + row]!];
  }
}
