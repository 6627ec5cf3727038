import { compose7 } from '../../../base/flat-math.js';
import type { Pose } from '../../../base/math.js';
import { MATRIX, writeMatrix } from '../../../base/matrix.js';
import { POSE } from '../../../dynamics/poses.js';
import type { Flat } from './solid.js';

/** Numbers of a frame: the rows of its turn, and its origin. */
export const FRAME = MATRIX + 3;

const placed = new Float64Array(POSE);

/** The frame of something that has a pose in a body: `poses[from]` is the body's. */
export function writeFrame(out: Flat, at: number, poses: Flat, from: number, own: Pose): void {
  compose7(placed, 0, poses, from, own);
  writeMatrix(out, at, placed, 3);
  for (let k = 0; k < 3; k++) out[at + MATRIX + k] = placed[k]!;
}

/** The point at a share of a way, x y z and how far it goes, as a frame has it, into `out[to]`. */
export function intoFrame(
  frames: Flat,
  at: number,
  way: Flat,
  share: number,
  out: Flat,
  to: number,
): void {
  const x = way[0]! + way[3]! * share - frames[at + MATRIX]!;
  const y = way[1]! + way[4]! * share - frames[at + MATRIX + 1]!;
  const z = way[2]! + way[5]! * share - frames[at + MATRIX + 2]!;
  out[to] = frames[at]! * x + frames[at + 3]! * y + frames[at + 6]! * z;
  out[to + 1] = frames[at + 1]! * x + frames[at + 4]! * y + frames[at + 7]! * z;
  out[to + 2] = frames[at + 2]! * x + frames[at + 5]! * y + frames[at + 8]! * z;
}

/** How far a way goes as a frame has it, into `out[3]`. */
export function wayIntoFrame(frames: Flat, at: number, way: Flat, out: Flat): void {
  const x = way[3]!;
  const y = way[4]!;
  const z = way[5]!;
  out[3] = frames[at]! * x + frames[at + 3]! * y + frames[at + 6]! * z;
  out[4] = frames[at + 1]! * x + frames[at + 4]! * y + frames[at + 7]! * z;
  out[5] = frames[at + 2]! * x + frames[at + 5]! * y + frames[at + 8]! * z;
}
