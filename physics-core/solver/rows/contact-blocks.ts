import { C } from './cone-contacts.js';
import type { BlockCholesky } from '../matrix/block-cholesky.js';
import { SIZE } from '../matrix/six-blocks.js';

/** Adds how a contact answers the velocities of its bodies, `p` and `q` of the matrix; -1: it does not move. */
export function addContact(
  matrix: BlockCholesky,
  w: Float64Array,
  c: Float64Array,
  at: number,
  p: number,
  q: number,
): void {
  const armA = at + C.armA;
  const armB = at + C.armB;
  if (p >= 0) addToBody(matrix.values, matrix.diagonal(p), w, c, armA);
  if (q >= 0) addToBody(matrix.values, matrix.diagonal(q), w, c, armB);
  if (p < 0 || q < 0) return;
  const between = matrix.between(p, q);
  if (between >= 0) takeFromPair(matrix.values, between, w, c, armA, armB);
  else takeFromPair(matrix.values, -1 - between, w, c, armB, armA);
}

/** H ← H + [1; S(r)] W [1, -S(r)], its lower half, with the arm r of the body and a symmetric W; S(r) v = r × v. */
function addToBody(h: Float64Array, at: number, w: Float64Array, c: Float64Array, r: number): void {
  h[at]! += w[0]!;
  h[at + SIZE]! += w[3]!;
  h[at + SIZE + 1]! += w[4]!;
  h[at + 2 * SIZE]! += w[6]!;
  h[at + 2 * SIZE + 1]! += w[7]!;
  h[at + 2 * SIZE + 2]! += w[8]!;
  addTurned(h, at + 3 * SIZE, w, c, r, r, 1);
}

/** H ← H - [1; S(r)] W [1, -S(s)], with the arms r and s of both bodies. */
function takeFromPair(
  h: Float64Array,
  at: number,
  w: Float64Array,
  c: Float64Array,
  r: number,
  s: number,
): void {
  addRow(h, at, -w[0]!, -w[1]!, -w[2]!, c, s);
  addRow(h, at + SIZE, -w[3]!, -w[4]!, -w[5]!, c, s);
  addRow(h, at + 2 * SIZE, -w[6]!, -w[7]!, -w[8]!, c, s);
  addTurned(h, at + 3 * SIZE, w, c, r, s, -1);
}

/** Three rows: ± S(r) W [1, -S(s)]. */
function addTurned(
  h: Float64Array,
  at: number,
  w: Float64Array,
  c: Float64Array,
  r: number,
  s: number,
  sign: 1 | -1,
): void {
  const rx = sign * c[r]!;
  const ry = sign * c[r + 1]!;
  const rz = sign * c[r + 2]!;
  const xx = w[0]!;
  const xy = w[1]!;
  const xz = w[2]!;
  const yy = w[4]!;
  const yz = w[5]!;
  const zz = w[8]!;
  addRow(h, at, ry * xz - rz * xy, ry * yz - rz * yy, ry * zz - rz * yz, c, s);
  addRow(h, at + SIZE, rz * xx - rx * xz, rz * xy - rx * yz, rz * xz - rx * zz, c, s);
  addRow(h, at + 2 * SIZE, rx * xy - ry * xx, rx * yy - ry * xy, rx * yz - ry * xz, c, s);
}

/** A row (x y z), and that times -S(s). */
function addRow(
  h: Float64Array,
  row: number,
  x: number,
  y: number,
  z: number,
  c: Float64Array,
  s: number,
): void {
  const sx = c[s]!;
  const sy = c[s + 1]!;
  const sz = c[s + 2]!;
  h[row]! += x;
  h[row + 1]! += y;
  h[row + 2]! += z;
  h[row + 3]! += sy * z - sz * y;
  h[row + 4]! += sz * x - sx * z;
  h[row + 5]! += sx * y - sy * x;
}
