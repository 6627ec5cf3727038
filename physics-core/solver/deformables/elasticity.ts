import { PART_SHARE } from '../tolerances.js';

export interface Elasticity {
  /** Pa. */
  readonly youngsModulus: number;
  readonly poissonsRatio: number;
}

/** The square of the greatest frequency that parts of so many seconds follow, 1/s². */
export function followed(time: number): number {
  return ((2 * PART_SHARE) / time) ** 2;
}
