import { cross, normalize, perpendicular, quaternionOfAxes } from '../../../physics-core/inside.js';

export { quaternionOf } from '../../../physics-core/inside.js';

/** Three rows of four: linear part and translation. */
export type Affine = number[];
export type Quaternion = [number, number, number, number];

export interface Pose {
  position: [number, number, number];
  quaternion: Quaternion;
}

const IDENTITY: Affine = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0];
export const identity = (): Affine => [...IDENTITY];

export function copyInto(from: Affine, out: Affine): Affine {
  for (let i = 0; i < 12; i++) out[i] = from[i];
  return out;
}

/** Into `out`, which must be neither `a` nor `b`. */
export function multiply(a: Affine, b: Affine, out: Affine = new Array(12)): Affine {
  for (let row = 0; row < 12; row += 4) {
    for (let column = 0; column < 4; column++) {
      out[row + column] =
        a[row] * b[column] +
        a[row + 1] * b[column + 4] +
        a[row + 2] * b[column + 8] +
        (column === 3 ? a[row + 3] : 0);
    }
  }
  return out;
}

/** The same with a 3 × 3 matrix on the right: a scale, a mirror, a shear. */
export function multiplyLinear(m: Affine, linear: readonly number[], out: Affine): Affine {
  for (let row = 0; row < 12; row += 4) {
    for (let column = 0; column < 3; column++) {
      out[row + column] =
        m[row] * linear[column] + m[row + 1] * linear[column + 3] + m[row + 2] * linear[column + 6];
    }
    out[row + 3] = m[row + 3];
  }
  return out;
}

/** A singular matrix (a scale of 0) has no inverse; the identity keeps what hangs on it finite. */
export function invert(m: Affine, out: Affine = new Array(12)): Affine {
  const a = m[0],
    b = m[1],
    c = m[2],
    d = m[4],
    e = m[5],
    f = m[6],
    g = m[8],
    h = m[9],
    i = m[10];
  const det = a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g);
  if (!(Math.abs(det) > 1e-30)) return copyInto(IDENTITY, out);
  const s = 1 / det;
  out[0] = (e * i - f * h) * s;
  out[1] = (c * h - b * i) * s;
  out[2] = (b * f - c * e) * s;
  out[4] = (f * g - d * i) * s;
  out[5] = (a * i - c * g) * s;
  out[6] = (c * d - a * f) * s;
  out[8] = (d * h - e * g) * s;
  out[9] = (b * g - a * h) * s;
  out[10] = (a * e - b * d) * s;
  for (let row = 0; row < 12; row += 4) {
    out[row + 3] = -(out[row] * m[3] + out[row + 1] * m[7] + out[row + 2] * m[11]);
  }
  return out;
}

export const translationMatrix = (x: number, y: number, z: number): Affine => [
  1,
  0,
  0,
  x,
  0,
  1,
  0,
  y,
  0,
  0,
  1,
  z,
];

/** The angle may be more than half a turn: what was said is not turned round. */
export function axisAngleOf([x, y, z, w]: Quaternion): [number, number, number, number] {
  const size = Math.hypot(x, y, z);
  return size < 1e-12 ? [0, 0, 1, 0] : [x / size, y / size, z / size, 2 * Math.atan2(size, w)];
}

export const matrixOf = ({ position, quaternion }: Pose): Affine =>
  poseMatrix([...position, ...quaternion], 0, 1);

/** The matrix of seven numbers, position and quaternion, from `at` on; lengths times `scale`. */
export function poseMatrix(
  data: ArrayLike<number>,
  at: number,
  scale: number,
  out: Affine = new Array(12),
): Affine {
  const x = data[at + 3],
    y = data[at + 4],
    z = data[at + 5],
    w = data[at + 6];
  out[0] = 1 - 2 * (y * y + z * z);
  out[1] = 2 * (x * y - z * w);
  out[2] = 2 * (x * z + y * w);
  out[4] = 2 * (x * y + z * w);
  out[5] = 1 - 2 * (x * x + z * z);
  out[6] = 2 * (y * z - x * w);
  out[8] = 2 * (x * z - y * w);
  out[9] = 2 * (y * z + x * w);
  out[10] = 1 - 2 * (x * x + y * y);
  out[3] = data[at] * scale;
  out[7] = data[at + 1] * scale;
  out[11] = data[at + 2] * scale;
  return out;
}

interface XYZW {
  x: number;
  y: number;
  z: number;
  w: number;
}

function setNormalised(out: XYZW, x: number, y: number, z: number, w: number): void {
  const s = 1 / Math.sqrt(x * x + y * y + z * z + w * w);
  out.x = x * s;
  out.y = y * s;
  out.z = z * s;
  out.w = w * s;
}

/** `Math.hypot` takes twenty times as long. */
const oneBy = (x: number, y: number, z: number): number => 1 / Math.sqrt(x * x + y * y + z * z);

/** Quaternion of a matrix's rotation, by the largest of its four components; a scale in it goes away. */
export function quaternionInto(m: Affine, out: XYZW): void {
  const sx = oneBy(m[0], m[4], m[8]),
    sy = oneBy(m[1], m[5], m[9]),
    sz = oneBy(m[2], m[6], m[10]);
  const a = m[0] * sx,
    b = m[1] * sy,
    c = m[2] * sz,
    d = m[4] * sx,
    e = m[5] * sy,
    f = m[6] * sz;
  const g = m[8] * sx,
    h = m[9] * sy,
    i = m[10] * sz;
  if (a + e + i > 0) setNormalised(out, h - f, c - g, d - b, 1 + a + e + i);
  else if (a > e && a > i) setNormalised(out, 1 + a - e - i, b + d, c + g, h - f);
  else if (e > i) setNormalised(out, b + d, 1 - a + e - i, f + h, c - g);
  else setNormalised(out, c + g, f + h, 1 - a - e + i, d - b);
}

export interface Decomposed extends Pose {
  /** Row-major 3 × 3: what is left when the rotation is taken off. Undefined: nothing. */
  linear: number[] | undefined;
}

const NEARLY = 1e-9;

/** Parts a matrix into a pose and the scale, mirror or shear that acts before it. */
export function decompose(m: Affine): Decomposed {
  const pose: Pose = { position: [m[3], m[7], m[11]], quaternion: rotationIn(m) };
  const rest = multiply(invert(matrixOf({ ...pose, position: [0, 0, 0] })), m);
  const linear = [rest[0], rest[1], rest[2], rest[4], rest[5], rest[6], rest[8], rest[9], rest[10]];
  const plain = linear.every(
    (value, index) => Math.abs(value - (index % 4 === 0 ? 1 : 0)) < NEARLY,
  );
  return { ...pose, linear: plain ? undefined : linear };
}

/** The rotation nearest to the columns' directions, always a proper one: a mirror stays in the linear part. */
function rotationIn(m: Affine): Quaternion {
  let x = normalize([m[0], m[4], m[8]], [1, 0, 0]);
  const along = x[0] * m[1] + x[1] * m[5] + x[2] * m[9];
  const y = normalize(
    [m[1] - along * x[0], m[5] - along * x[1], m[9] - along * x[2]],
    perpendicular(x),
  );
  let z = cross(x, y);
  if (z[0] * m[2] + z[1] * m[6] + z[2] * m[10] < 0) {
    // Mirrored: turning the first axis round as well keeps the rotation proper.
    x = [-x[0], -x[1], -x[2]];
    z = [-z[0], -z[1], -z[2]];
  }
  return quaternionOfAxes(x, y, z);
}

export function withLinear(m: Affine, linear: readonly number[] | undefined): Affine {
  if (!linear) return m;
  const [a, b, c, d, e, f, g, h, i] = linear;
  return multiply(m, [a, b, c, 0, d, e, f, 0, g, h, i, 0]);
}

export const isIdentity = (m: Affine): boolean =>
  m.every((value, index) => value === (index % 5 === 0 ? 1 : 0));
