import { atan2, cos, hypot, sin } from './exact/index.js';
import type { Rotation, Vec3 } from '../fields/types.js';

/** Unit quaternion: x, y, z, w. */
export type Quaternion = [number, number, number, number];

/** A rigid pose. */
export interface Pose {
  p: Vec3;
  q: Quaternion;
}

export const IDENTITY: Quaternion = [0, 0, 0, 1];
export const identityPose = (): Pose => ({ p: [0, 0, 0], q: [0, 0, 0, 1] });

/** Unit vectors along x, y and z. */
export const AXES: readonly [Vec3, Vec3, Vec3] = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];

export const add = (a: Vec3, b: Vec3): Vec3 => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const subtract = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const scale = (a: Vec3, s: number): Vec3 => [a[0] * s, a[1] * s, a[2] * s];
export const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const length = (a: Vec3): number => hypot(a[0], a[1], a[2]);
export const cross = (a: Vec3, b: Vec3): Vec3 => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

/** `fallback` where the vector has no direction. */
export function normalize(a: Vec3, fallback: Vec3 = [0, 1, 0]): Vec3 {
  const size = length(a);
  return size > 1e-12 ? scale(a, 1 / size) : [...fallback];
}

/** Some unit vector at right angles to the unit vector `a`. */
export function perpendicular(a: Vec3): Vec3 {
  return normalize(cross(a, Math.abs(a[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0]));
}

/** A zero axis means no rotation: x3dom writes `0,0,0,0` as its default. */
export function quaternionOf([x, y, z, angle]: readonly number[]): Quaternion {
  const size = hypot(x!, y!, z!);
  if (size < 1e-12) return [0, 0, 0, 1];
  const s = sin(angle! / 2) / size;
  return [x! * s, y! * s, z! * s, cos(angle! / 2)];
}

/** Axis and angle in [0, π]. */
export function rotationOf(q: ArrayLike<number>): Rotation {
  const sign = q[3]! < 0 ? -1 : 1;
  const s = hypot(q[0]!, q[1]!, q[2]!);
  if (s < 1e-9) return [0, 0, 1, 0];
  const angle = 2 * atan2(s, sign * q[3]!);
  return [(sign * q[0]!) / s, (sign * q[1]!) / s, (sign * q[2]!) / s, angle];
}

export function multiply(a: Quaternion, b: Quaternion): Quaternion {
  return [
    a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1],
    a[3] * b[1] - a[0] * b[2] + a[1] * b[3] + a[2] * b[0],
    a[3] * b[2] + a[0] * b[1] - a[1] * b[0] + a[2] * b[3],
    a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2],
  ];
}

export const conjugate = (q: Quaternion): Quaternion => [-q[0], -q[1], -q[2], q[3]];

export function rotate(q: Quaternion, v: Vec3): Vec3 {
  const t = scale(cross([q[0], q[1], q[2]], v), 2);
  return add(add(v, scale(t, q[3])), cross([q[0], q[1], q[2]], t));
}

/** The pose `b`, given in the frame of `a`, in the frame `a` is given in. */
export const compose = (a: Pose, b: Pose): Pose => ({
  p: add(a.p, rotate(a.q, b.p)),
  q: multiply(a.q, b.q),
});

export function invert(a: Pose): Pose {
  const q = conjugate(a.q);
  return { p: scale(rotate(q, a.p), -1), q };
}

/** Quaternion of the rotation matrix with these rows. */
export function quaternionOfRows(
  m00: number,
  m01: number,
  m02: number,
  m10: number,
  m11: number,
  m12: number,
  m20: number,
  m21: number,
  m22: number,
): Quaternion {
  const out: Quaternion = [0, 0, 0, 1];
  writeQuaternion(out, 0, m00, m01, m02, m10, m11, m12, m20, m21, m22);
  return out;
}

/** Shepperd's method: the largest of the four components first, so that no root loses digits. */
export function writeQuaternion(
  out: number[] | Float64Array,
  at: number,
  m00: number,
  m01: number,
  m02: number,
  m10: number,
  m11: number,
  m12: number,
  m20: number,
  m21: number,
  m22: number,
): void {
  const trace = m00 + m11 + m22;
  if (trace > 0) {
    const s = 0.5 / Math.sqrt(trace + 1);
    out[at] = (m21 - m12) * s;
    out[at + 1] = (m02 - m20) * s;
    out[at + 2] = (m10 - m01) * s;
    out[at + 3] = 0.25 / s;
  } else if (m00 > m11 && m00 > m22) {
    const s = 2 * Math.sqrt(1 + m00 - m11 - m22);
    out[at] = 0.25 * s;
    out[at + 1] = (m01 + m10) / s;
    out[at + 2] = (m02 + m20) / s;
    out[at + 3] = (m21 - m12) / s;
  } else if (m11 > m22) {
    const s = 2 * Math.sqrt(1 + m11 - m00 - m22);
    out[at] = (m01 + m10) / s;
    out[at + 1] = 0.25 * s;
    out[at + 2] = (m12 + m21) / s;
    out[at + 3] = (m02 - m20) / s;
  } else {
    const s = 2 * Math.sqrt(1 + m22 - m00 - m11);
    out[at] = (m02 + m20) / s;
    out[at + 1] = (m12 + m21) / s;
    out[at + 2] = 0.25 * s;
    out[at + 3] = (m10 - m01) / s;
  }
}

/** Quaternion of the frame with the unit axes x, y, z as columns. */
export const quaternionOfAxes = (x: Vec3, y: Vec3, z: Vec3): Quaternion =>
  quaternionOfRows(x[0], y[0], z[0], x[1], y[1], z[1], x[2], y[2], z[2]);
