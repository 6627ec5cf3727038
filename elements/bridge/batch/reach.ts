import type { Affine } from '../geometry/matrix.js';
import type { X3DVolume } from '../x3dom/renderer.js';

/** Least x, y, z, then the greatest. */
export const BOX = 6;

type Numbers = Float64Array | number[];

/** What x3dom does not know is a point, as it has it. */
export const boxOf = ({ min, max, valid }: X3DVolume): number[] =>
  valid ? [min.x, min.y, min.z, max.x, max.y, max.z] : new Array<number>(BOX).fill(0);

/**
 * The bounds of a box that a matrix takes elsewhere, into `out` from `at` on; they may be the box itself. To the last bit
 * as x3dom adds it up, since shadows hang on that.
 */
export function reachInto(m: Affine, box: Numbers, out: Numbers, at: number): void {
  const x0 = box[0]!;
  const y0 = box[1]!;
  const z0 = box[2]!;
  const x1 = box[3]!;
  const y1 = box[4]!;
  const z1 = box[5]!;
  for (let axis = 0; axis < 3; axis++) {
    const row = 4 * axis;
    const origin = m[row + 3];
    const ax = m[row] * x0;
    const bx = m[row] * x1;
    const ay = m[row + 1] * y0;
    const by = m[row + 1] * y1;
    const az = m[row + 2] * z0;
    const bz = m[row + 2] * z1;
    out[at + axis] = origin + (ax < bx ? ax : bx) + (ay < by ? ay : by) + (az < bz ? az : bz);
    out[at + axis + 3] = origin + (ax < bx ? bx : ax) + (ay < by ? by : ay) + (az < bz ? bz : az);
  }
}
