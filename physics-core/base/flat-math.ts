import { cos, hypot, sin } from './exact/index.js';
import type { Pose } from './math.js';
import { writeAxes } from './matrix.js';

/** Vectors inside flat arrays, three numbers each from an index on: nothing is allocated. */
type Numbers = Float64Array;

const product = new Float64Array(4);

export const dot3 = (a: Numbers, i: number, b: Numbers, j: number): number =>
  a[i]! * b[j]! + a[i + 1]! * b[j + 1]! + a[i + 2]! * b[j + 2]!;

export const dot4 = (a: Numbers, i: number, b: Numbers, j: number): number =>
  dot3(a, i, b, j) + a[i + 3]! * b[j + 3]!;

/** out = a × b. `out` may be neither of them. */
export function cross3(
  out: Numbers,
  o: number,
  a: Numbers,
  i: number,
  b: Numbers,
  j: number,
): void {
  out[o] = a[i + 1]! * b[j + 2]! - a[i + 2]! * b[j + 1]!;
  out[o + 1] = a[i + 2]! * b[j]! - a[i]! * b[j + 2]!;
  out[o + 2] = a[i]! * b[j + 1]! - a[i + 1]! * b[j]!;
}

/** out = a b for quaternions (x, y, z, w); `out` may be either of them. */
export function multiply4(
  out: Numbers,
  a: ArrayLike<number>,
  i: number,
  b: ArrayLike<number>,
  j: number,
): void {
  const ax = a[i]!;
  const ay = a[i + 1]!;
  const az = a[i + 2]!;
  const aw = a[i + 3]!;
  const bx = b[j]!;
  const by = b[j + 1]!;
  const bz = b[j + 2]!;
  const bw = b[j + 3]!;
  out[0] = aw * bx + ax * bw + ay * bz - az * by;
  out[1] = aw * by - ax * bz + ay * bw + az * bx;
  out[2] = aw * bz + ax * by - ay * bx + az * bw;
  out[3] = aw * bw - ax * bx - ay * by - az * bz;
}

/** out = the pose of a frame given in a body, where the body is: as `compose`. */
export function compose7(out: Numbers, o: number, body: Numbers, i: number, { p, q }: Pose): void {
  const x = body[i + 3]!;
  const y = body[i + 4]!;
  const z = body[i + 5]!;
  const w = body[i + 6]!;
  const u = (y * p[2] - z * p[1]) * 2;
  const v = (z * p[0] - x * p[2]) * 2;
  const t = (x * p[1] - y * p[0]) * 2;
  out[o] = body[i]! + (p[0] + u * w + (y * t - z * v));
  out[o + 1] = body[i + 1]! + (p[1] + v * w + (z * u - x * t));
  out[o + 2] = body[i + 2]! + (p[2] + t * w + (x * v - y * u));
  multiply4(product, body, i + 3, q, 0);
  for (let k = 0; k < 4; k++) out[o + 3 + k] = product[k]!;
}

/** The quaternion of a turn by `time` seconds at `spin`, rad/s about each axis. */
export function writeTurn(out: Numbers, spin: Numbers, time: number): void {
  const speed = hypot(spin[0]!, spin[1]!, spin[2]!);
  const s = speed > 1e-12 ? sin((speed * time) / 2) / speed : time / 2;
  for (let i = 0; i < 3; i++) out[i] = spin[i]! * s;
  out[3] = cos((speed * time) / 2);
}

/** Origin and axes, in the world, of a frame given in a body: `centre` is the body's pose, `principal` its axes. */
export function place(
  origin: Numbers,
  axes: Numbers,
  centre: Numbers,
  principal: Numbers,
  frame: Pose,
): void {
  const { p } = frame;
  for (let i = 0; i < 3; i++)
    origin[i] =
      centre[i]! + principal[i]! * p[0] + principal[3 + i]! * p[1] + principal[6 + i]! * p[2];
  multiply4(product, centre, 3, frame.q, 0);
  writeAxes(axes, product, 0);
}

const between = new Float64Array(3);

/** out = ±(point - centre) × axis: what a push along the axis at the point turns. */
export function arm(
  out: Numbers,
  o: number,
  point: Numbers,
  centre: Numbers,
  axes: Numbers,
  at: number,
  sign: 1 | -1,
): void {
  for (let i = 0; i < 3; i++) between[i] = sign * (point[i]! - centre[i]!);
  cross3(out, o, between, 0, axes, at);
}

/** out = I v for a body with these principal axes and moments, all in the world. */
export function applyInertia(
  out: Numbers,
  o: number,
  principal: Numbers,
  moments: ArrayLike<number>,
  v: Numbers,
  at: number,
): void {
  const x = dot3(principal, 0, v, at) * moments[0]!;
  const y = dot3(principal, 3, v, at) * moments[1]!;
  const z = dot3(principal, 6, v, at) * moments[2]!;
  for (let i = 0; i < 3; i++)
    out[o + i] = principal[i]! * x + principal[3 + i]! * y + principal[6 + i]! * z;
}

/** out = I⁻¹ v. */
export function applyInverseInertia(
  out: Numbers,
  o: number,
  principal: Numbers,
  moments: ArrayLike<number>,
  v: Numbers,
  at: number,
): void {
  const x = dot3(principal, 0, v, at) / moments[0]!;
  const y = dot3(principal, 3, v, at) / moments[1]!;
  const z = dot3(principal, 6, v, at) / moments[2]!;
  for (let i = 0; i < 3; i++)
    out[o + i] = principal[i]! * x + principal[3 + i]! * y + principal[6 + i]! * z;
}
