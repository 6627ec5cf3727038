import { C } from './cone-contacts.js';
import { SIZE, type SparseCholesky } from '../matrix/block-cholesky.js';

/** Numbers of `placesOf`. */
export const PLACES = 3;

/**
 * Where the blocks of two bodies, `p` and `q` of the matrix (-1: it does not move), begin in its values: of each by itself,
 * -1 for none, and between both as `SparseCholesky` tells it.
 */
export function placesOf(
  matrix: SparseCholesky,
  p: number,
  q: number,
  out: Int32Array,
  at: number,
): void {
  out[at] = p < 0 ? -1 : matrix.diagonal(p);
  out[at + 1] = q < 0 ? -1 : matrix.diagonal(q);
  out[at + 2] = p < 0 || q < 0 ? 0 : matrix.between(p, q);
}

/** Adds to values `h` how a contact answers the velocities of its bodies, whose blocks are at `places[k]`. */
export function addContact(
  h: Float64Array,
  w: Float64Array,
  c: Float64Array,
  at: number,
  places: Int32Array,
  k: number,
): void {
  const armA = at + C.armA;
  const armB = at + C.armB;
  const a = places[k]!;
  const b = places[k + 1]!;
  if (a >= 0) addToBody(h, a, w, c, armA);
  if (b >= 0) addToBody(h, b, w, c, armB);
  if (a < 0 || b < 0) return;
  const between = places[k + 2]!;
  if (between >= 0) takeFromPair(h, between, w, c, armA, armB);
  else takeFromPair(h, -1 - between, w, c, armB, armA);
}

/** H ← H + [1; S(r)] W [1, -S(r)], its lower half, with the arm r of the body and a symmetric W; S(r) v = r × v. */
function addToBody(h: Float64Array, at: number, w: Float64Array, c: Float64Array, r: number): void {
  const rx = c[r]!;
  const ry = c[r + 1]!;
  const rz = c[r + 2]!;
  const xx = w[0]!;
  const xy = w[1]!;
  const xz = w[2]!;
  const yy = w[4]!;
  const yz = w[5]!;
  const zz = w[8]!;
  h[at]! += xx;
  h[at + SIZE]! += xy;
  h[at + SIZE + 1]! += yy;
  h[at + 2 * SIZE]! += xz;
  h[at + 2 * SIZE + 1]! += yz;
  h[at + 2 * SIZE + 2]! += zz;
  // S(r) W
  const x0 = ry * xz - rz * xy;
  const x1 = ry * yz - rz * yy;
  const x2 = ry * zz - rz * yz;
  const y0 = rz * xx - rx * xz;
  const y1 = rz * xy - rx * yz;
  const y2 = rz * xz - rx * zz;
  const z0 = rx * xy - ry * xx;
  const z1 = rx * yy - ry * xy;
  const z2 = rx * yz - ry * xz;
  const row = at + 3 * SIZE;
  h[row]! += x0;
  h[row + 1]! += x1;
  h[row + 2]! += x2;
  h[row + 3]! += ry * x2 - rz * x1;
  h[row + SIZE]! += y0;
  h[row + SIZE + 1]! += y1;
  h[row + SIZE + 2]! += y2;
  h[row + SIZE + 3]! += ry * y2 - rz * y1;
  h[row + SIZE + 4]! += rz * y0 - rx * y2;
  h[row + 2 * SIZE]! += z0;
  h[row + 2 * SIZE + 1]! += z1;
  h[row + 2 * SIZE + 2]! += z2;
  h[row + 2 * SIZE + 3]! += ry * z2 - rz * z1;
  h[row + 2 * SIZE + 4]! += rz * z0 - rx * z2;
  h[row + 2 * SIZE + 5]! += rx * z1 - ry * z0;
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
  const rx = c[r]!;
  const ry = c[r + 1]!;
  const rz = c[r + 2]!;
  const xx = w[0]!;
  const xy = w[1]!;
  const xz = w[2]!;
  const yy = w[4]!;
  const yz = w[5]!;
  const zz = w[8]!;
  takeRow(h, at, xx, xy, xz, c, s);
  takeRow(h, at + SIZE, xy, yy, yz, c, s);
  takeRow(h, at + 2 * SIZE, xz, yz, zz, c, s);
  takeRow(h, at + 3 * SIZE, ry * xz - rz * xy, ry * yz - rz * yy, ry * zz - rz * yz, c, s);
  takeRow(h, at + 4 * SIZE, rz * xx - rx * xz, rz * xy - rx * yz, rz * xz - rx * zz, c, s);
  takeRow(h, at + 5 * SIZE, rx * xy - ry * xx, rx * yy - ry * xy, rx * yz - ry * xz, c, s);
}

/** A row of W or S(r) W, and that times -S(s). */
function takeRow(
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
  h[row]! -= x;
  h[row + 1]! -= y;
  h[row + 2]! -= z;
  h[row + 3]! -= sy * z - sz * y;
  h[row + 4]! -= sz * x - sx * z;
  h[row + 5]! -= sx * y - sy * x;
}
