import { hypot } from '../base/exact/index.js';
import { quaternionOfRows, type Quaternion } from '../base/math.js';
import type { Vec3 } from '../fields/types.js';
import type { Geometry } from './geometry.js';
import { meshes } from './meshes.js';
import { axisScale } from './scale.js';

/** Symmetric 3 × 3: xx, yy, zz, xy, xz, yz. */
export type Tensor = [number, number, number, number, number, number];

/** A solid of density 1. `inertia` is about `centroid`. */
export interface Solid {
  volume: number;
  centroid: Vec3;
  inertia: Tensor;
}

export const diagonal = (
  volume: number,
  x: number,
  y: number,
  z: number,
  centroid: Vec3 = [0, 0, 0],
): Solid => ({
  volume,
  centroid,
  inertia: [volume * x, volume * y, volume * z, 0, 0, 0],
});

export const boxSolid = (x: number, y: number, z: number): Solid =>
  diagonal(x * y * z, (y * y + z * z) / 12, (x * x + z * z) / 12, (x * x + y * y) / 12);

function cylinderSolid(r: number, h: number): Solid {
  const side = (3 * r * r + h * h) / 12;
  return diagonal(Math.PI * r * r * h, side, (r * r) / 2, side);
}

/** X3D's cone has its origin at half height; its centroid lies a quarter of the height above the base. */
function coneSolid(r: number, h: number): Solid {
  const side = (3 / 80) * (4 * r * r + h * h);
  return diagonal((Math.PI * r * r * h) / 3, side, 0.3 * r * r, side, [0, -h / 4, 0]);
}

/** The solid a geometry encloses, in the frame of its collidable before translation and rotation. */
export function solidOf(g: Geometry): Solid {
  const s = axisScale(g.linear);
  if (s) {
    const [x, y, z] = s;
    if (g.type === 'Box') {
      const [w, h, d] = g.size ?? [2, 2, 2];
      return boxSolid(w * x, h * y, d * z);
    }
    if (g.type === 'Sphere' && x === y && y === z) {
      const r = (g.radius ?? 1) * x;
      return diagonal((4 / 3) * Math.PI * r ** 3, 0.4 * r * r, 0.4 * r * r, 0.4 * r * r);
    }
    if (g.type === 'Cylinder' && x === z)
      return cylinderSolid((g.radius ?? 1) * x, (g.height ?? 2) * y);
    if (g.type === 'Cone' && x === z && !g.topRadius)
      return coneSolid((g.bottomRadius ?? 1) * x, (g.height ?? 2) * y);
  }
  return meshes.code.solidOf(g);
}

/** Adds `volume` displaced by `d` from the reference point (parallel axes). */
function displaced([xx, yy, zz, xy, xz, yz]: Tensor, mass: number, [x, y, z]: Vec3): Tensor {
  return [
    xx + mass * (y * y + z * z),
    yy + mass * (x * x + z * z),
    zz + mass * (x * x + y * y),
    xy - mass * x * y,
    xz - mass * x * z,
    yz - mass * y * z,
  ];
}

/** R · I · Rᵀ for the rotation with these columns. */
function rotated(t: Tensor, axes: readonly [Vec3, Vec3, Vec3]): Tensor {
  const full = [
    [t[0], t[3], t[4]],
    [t[3], t[1], t[5]],
    [t[4], t[5], t[2]],
  ];
  const at = (i: number, j: number): number => {
    let sum = 0;
    for (let k = 0; k < 3; k++)
      for (let l = 0; l < 3; l++) sum += axes[k]![i]! * full[k]![l]! * axes[l]![j]!;
    return sum;
  };
  return [at(0, 0), at(1, 1), at(2, 2), at(0, 1), at(0, 2), at(1, 2)];
}

/** A solid, and the pose of its frame in the body as columns and origin. */
export interface PlacedSolid {
  solid: Solid;
  axes: readonly [Vec3, Vec3, Vec3];
  origin: Vec3;
}

/** Inertia of the placed solids about `center`, for the whole `mass` spread evenly over their volume. */
export function inertiaAbout(solids: PlacedSolid[], mass: number, center: Vec3): Tensor {
  const volume = solids.reduce((sum, { solid }) => sum + solid.volume, 0);
  if (!(volume > 0)) return [0.4 * mass, 0.4 * mass, 0.4 * mass, 0, 0, 0];
  const total: Tensor = [0, 0, 0, 0, 0, 0];
  for (const { solid, axes, origin } of solids) {
    const c = solid.centroid;
    const offset = [0, 1, 2].map(
      (i) => origin[i]! + axes[0][i]! * c[0] + axes[1][i]! * c[1] + axes[2][i]! * c[2] - center[i]!,
    ) as Vec3;
    const part = displaced(rotated(solid.inertia, axes), solid.volume, offset);
    part.forEach((value, i) => (total[i]! += (value * mass) / volume));
  }
  return total;
}

/** Jacobi's method: the principal moments and the frame they belong to. Diagonal tensors keep the body's axes. */
export function principal(t: Tensor): { moments: Vec3; frame: Quaternion } {
  const a = [
    [t[0], t[3], t[4]],
    [t[3], t[1], t[5]],
    [t[4], t[5], t[2]],
  ];
  const v = [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ];
  const size = Math.abs(t[0]) + Math.abs(t[1]) + Math.abs(t[2]);
  for (let sweep = 0; sweep < 32; sweep++) {
    if (Math.abs(a[0]![1]!) + Math.abs(a[0]![2]!) + Math.abs(a[1]![2]!) <= 1e-14 * size) break;
    for (const [p, q] of [
      [0, 1],
      [0, 2],
      [1, 2],
    ] as const) {
      if (a[p]![q] === 0) continue;
      const theta = (a[q]![q]! - a[p]![p]!) / (2 * a[p]![q]!);
      const tan = Math.sign(theta || 1) / (Math.abs(theta) + hypot(theta, 1));
      const cos = 1 / hypot(tan, 1);
      const sin = tan * cos;
      for (let k = 0; k < 3; k++) {
        const [kp, kq] = [a[k]![p]!, a[k]![q]!];
        a[k]![p] = cos * kp - sin * kq;
        a[k]![q] = sin * kp + cos * kq;
      }
      for (let k = 0; k < 3; k++) {
        const [pk, qk] = [a[p]![k]!, a[q]![k]!];
        a[p]![k] = cos * pk - sin * qk;
        a[q]![k] = sin * pk + cos * qk;
        const [vp, vq] = [v[k]![p]!, v[k]![q]!];
        v[k]![p] = cos * vp - sin * vq;
        v[k]![q] = sin * vp + cos * vq;
      }
    }
  }
  const [r0, r1, r2] = v as [number[], number[], number[]];
  return {
    moments: [a[0]![0]!, a[1]![1]!, a[2]![2]!],
    frame: quaternionOfRows(r0[0]!, r0[1]!, r0[2]!, r1[0]!, r1[1]!, r1[2]!, r2[0]!, r2[1]!, r2[2]!),
  };
}
