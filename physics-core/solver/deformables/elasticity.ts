import { PART_SHARE } from '../tolerances.js';

export interface Elasticity {
  /** Pa. */
  readonly youngsModulus: number;
  readonly poissonsRatio: number;
}

/** The square of the greatest frequency that parts of so many seconds follow, 1/s². */
export function followed(time: number): number {
  const most = (2 * PART_SHARE) / time;
  return most * most;
}
