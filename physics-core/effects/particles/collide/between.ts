import { POSE } from '../../../dynamics/poses.js';

/**
 * The pose from `at` on at a share of the way from one list to another: a straight line for the place, the normalised line for
 * the quaternion. What is drawn between two steps goes so, too.
 */
export function between(
  first: Float64Array,
  last: Float64Array,
  at: number,
  share: number,
  out: Float64Array,
): void {
  let same = 0;
  for (let k = 3; k < POSE; k++) same += first[at + k]! * last[at + k]!;
  const rest = 1 - share;
  const sign = same < 0 ? -share : share;
  let size = 0;
  for (let k = 0; k < 3; k++) out[k] = first[at + k]! + (last[at + k]! - first[at + k]!) * share;
  for (let k = 3; k < POSE; k++) {
    out[k] = first[at + k]! * rest + last[at + k]! * sign;
    size += out[k]! * out[k]!;
  }
  for (let k = 3; k < POSE; k++) out[k]! /= Math.sqrt(size);
}
