import type { Affine } from '../geometry/matrix.js';
import type { X3DMatrix } from '../x3dom/x3dom.js';

// x3dom's own products: the same sums in the same order, in double precision. What comes out is the same to the last bit,
// and so is the picture.

/** Row by row: four of a matrix of x3dom's, three of what stands in the world. */
export type Rows = Float64Array;

/** Numbers of what stands in the world. */
export const AFFINE = 12;

/** `above` × `local`. */
export function placeInto(above: Affine, local: Affine, out: Rows, to: number): void {
  for (let row = 0; row < AFFINE; row += 4) {
    const a = above[row];
    const b = above[row + 1];
    const c = above[row + 2];
    out[to + row] = a * local[0] + b * local[4] + c * local[8];
    out[to + row + 1] = a * local[1] + b * local[5] + c * local[9];
    out[to + row + 2] = a * local[2] + b * local[6] + c * local[10];
    out[to + row + 3] = a * local[3] + b * local[7] + c * local[11] + above[row + 3];
  }
}

const FIELDS = [
  ...['_00', '_01', '_02', '_03', '_10', '_11', '_12', '_13'],
  ...['_20', '_21', '_22', '_23', '_30', '_31', '_32', '_33'],
] as Exclude<keyof X3DMatrix, 'mult'>[];

/** Of no matrix: any is another one. */
export const unread = (): Rows => new Float64Array(FIELDS.length).fill(NaN);

/** Whether it is another one than `out` had. */
export function read(matrix: X3DMatrix, out: Rows): boolean {
  let isOther = false;
  for (let i = 0; i < FIELDS.length; i++) {
    const value = matrix[FIELDS[i]!];
    if (out[i] === value) continue;
    out[i] = value;
    isOther = true;
  }
  return isOther;
}

/** `camera` × `model` in four columns. */
export function putProjected(
  camera: Rows,
  model: Rows,
  at: number,
  out: Float32Array,
  to: number,
): void {
  for (let column = 0; column < 4; column++) {
    const x = model[at + column]!,
      y = model[at + 4 + column]!,
      z = model[at + 8 + column]!,
      w = column === 3 ? 1 : 0;
    for (let row = 0; row < 4; row++) {
      const i = 4 * row;
      out[to + 4 * column + row] =
        camera[i]! * x + camera[i + 1]! * y + camera[i + 2]! * z + camera[i + 3]! * w;
    }
  }
}

/** `view` × `model`. */
export function multiplyInto(view: Rows, model: Rows, at: number, out: Rows): void {
  for (let row = 0; row < AFFINE; row += 4) {
    const a = view[row]!,
      b = view[row + 1]!,
      c = view[row + 2]!;
    for (let column = 0; column < 4; column++)
      out[row + column] =
        a * model[at + column]! + b * model[at + 4 + column]! + c * model[at + 8 + column]!;
    out[row + 3]! += view[row + 3]!;
  }
}

/** The linear part in three columns, beside each a number of the translation. */
export function putAffine(matrix: Rows, at: number, out: Float32Array, to: number): void {
  for (let axis = 0; axis < 3; axis++) {
    const i = to + 4 * axis;
    for (let row = 0; row < 3; row++) out[i + row] = matrix[at + 4 * row + axis]!;
    out[i + 3] = matrix[at + 4 * axis + 3]!;
  }
}

/**
 * For normals, in three columns: the transpose of the inverse. `w`: the last number of the matrix that x3dom inverts, in
 * its cameras one but for rounding.
 */
export function putNormals(m: Rows, w: number, out: Float32Array, to: number): void {
  const a = m[0]!,
    b = m[1]!,
    c = m[2]!,
    d = m[4]!,
    e = m[5]!,
    f = m[6]!,
    g = m[8]!,
    h = m[9]!,
    i = m[10]!;
  const x = e * i * w - f * h * w;
  const y = b * i * w - c * h * w;
  const z = b * f * w - c * e * w;
  const size = a * x - d * y + g * z;
  if (size === 0) return putIdentity(out, to);
  const by = 1 / size;
  out[to] = x * by;
  out[to + 1] = -y * by;
  out[to + 2] = z * by;
  out[to + 4] = -(d * i * w - f * g * w) * by;
  out[to + 5] = (a * i * w - c * g * w) * by;
  out[to + 6] = -(a * f * w - c * d * w) * by;
  out[to + 8] = (d * h * w - e * g * w) * by;
  out[to + 9] = -(a * h * w - b * g * w) * by;
  out[to + 10] = (a * e * w - b * d * w) * by;
}

/** What x3dom takes where there is no inverse. */
function putIdentity(out: Float32Array, to: number): void {
  for (let column = 0; column < 3; column++)
    for (let row = 0; row < 3; row++) out[to + 4 * column + row] = column === row ? 1 : 0;
}
