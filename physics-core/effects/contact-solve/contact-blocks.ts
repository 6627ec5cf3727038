import { C } from './cone-contacts.js';
import { SIZE, type SparseCholesky } from './sparse-cholesky.js';

/** Adds how a contact answers the velocities of its bodies, `p` and `q` of the matrix; -1: it does not move. */
export function addContact(
  matrix: SparseCholesky,
  w: Float64Array,
  c: Float64Array,
  at: number,
  p: number,
  q: number,
): void {
  const armA = at + C.armA;
  const armB = at + C.armB;
  if (p >= 0) addBlock(matrix.values, matrix.diagonal(p), w, c, armA, armA, 1);
  if (q >= 0) addBlock(matrix.values, matrix.diagonal(q), w, c, armB, armB, 1);
  if (p < 0 || q < 0) return;
  const between = matrix.between(p, q);
  if (between >= 0) addBlock(matrix.values, between, w, c, armA, armB, -1);
  else addBlock(matrix.values, -1 - between, w, c, armB, armA, -1);
}

/** H ← H ± [1; S(r)] W [1, -S(s)], with the arms r and s of both bodies; S(r) v = r × v. */
function addBlock(
  h: Float64Array,
  at: number,
  w: Float64Array,
  c: Float64Array,
  r: number,
  s: number,
  sign: 1 | -1,
): void {
  const rx = c[r]!;
  const ry = c[r + 1]!;
  const rz = c[r + 2]!;
  const sx = c[s]!;
  const sy = c[s + 1]!;
  const sz = c[s + 2]!;
  for (let j = 0; j < 3; j++) {
    // A row of W is a column, too: first as it is, then as a column of -W S(s).
    const x = w[3 * j]! * sign;
    const y = w[3 * j + 1]! * sign;
    const z = w[3 * j + 2]! * sign;
    addColumn(h, at + j, x, y, z, rx, ry, rz);
    const row = at + j * SIZE;
    h[row + 3]! += sy * z - sz * y;
    h[row + 4]! += sz * x - sx * z;
    h[row + 5]! += sx * y - sy * x;
  }
  addTurning(h, at, w, sign, rx, ry, rz, sx, sy, sz);
}

/** A column of W, and turned by S(r) below it. */
function addColumn(
  h: Float64Array,
  at: number,
  x: number,
  y: number,
  z: number,
  rx: number,
  ry: number,
  rz: number,
): void {
  h[at]! += x;
  h[at + SIZE]! += y;
  h[at + 2 * SIZE]! += z;
  h[at + 3 * SIZE]! += ry * z - rz * y;
  h[at + 4 * SIZE]! += rz * x - rx * z;
  h[at + 5 * SIZE]! += rx * y - ry * x;
}

/** -S(r) W S(s) */
function addTurning(
  h: Float64Array,
  at: number,
  w: Float64Array,
  sign: 1 | -1,
  rx: number,
  ry: number,
  rz: number,
  sx: number,
  sy: number,
  sz: number,
): void {
  for (let i = 0; i < 3; i++) {
    // Row i of S(r) W.
    const p = i === 0 ? 0 : i === 1 ? rz : -ry;
    const q = i === 0 ? -rz : i === 1 ? 0 : rx;
    const t = i === 0 ? ry : i === 1 ? -rx : 0;
    const x = sign * (p * w[0]! + q * w[3]! + t * w[6]!);
    const y = sign * (p * w[1]! + q * w[4]! + t * w[7]!);
    const z = sign * (p * w[2]! + q * w[5]! + t * w[8]!);
    const row = at + (3 + i) * SIZE + 3;
    h[row]! += sy * z - sz * y;
    h[row + 1]! += sz * x - sx * z;
    h[row + 2]! += sx * y - sy * x;
  }
}
