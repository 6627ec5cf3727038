import { hypot } from '../base/exact/index.js';
import { quaternionOfRows, type Quaternion } from '../base/math.js';
import type { Vec3 } from '../fields/types.js';
import type { Geometry, Mesh } from './geometry.js';
import { axisScale } from './scale.js';
import { tessellate } from './tessellate.js';

/** Symmetric 3 × 3: xx, yy, zz, xy, xz, yz. */
export type Tensor = [number, number, number, number, number, number];

/** A solid of density 1. `inertia` is about `centroid`. */
export interface Solid {
  volume: number;
  centroid: Vec3;
  inertia: Tensor;
}

const diagonal = (
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

const boxSolid = (x: number, y: number, z: number): Solid =>
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

/** Sums signed tetrahedra between the origin and each triangle (Tonon 2004); exact for closed meshes. */
function meshSolid({ points, index }: Mesh): Solid | undefined {
  let volume = 0;
  const first: Vec3 = [0, 0, 0];
  const second: Tensor = [0, 0, 0, 0, 0, 0];
  const pairs = [
    [0, 0],
    [1, 1],
    [2, 2],
    [0, 1],
    [0, 2],
    [1, 2],
  ] as const;
  for (let t = 0; t < index.length; t += 3) {
    const [a, b, c] = [0, 1, 2].map((k) =>
      points.slice(index[t + k]! * 3, index[t + k]! * 3 + 3),
    ) as [Vec3, Vec3, Vec3];
    const v =
      (a[0] * (b[1] * c[2] - b[2] * c[1]) -
        a[1] * (b[0] * c[2] - b[2] * c[0]) +
        a[2] * (b[0] * c[1] - b[1] * c[0])) /
      6;
    volume += v;
    for (let i = 0; i < 3; i++) first[i]! += (v * (a[i]! + b[i]! + c[i]!)) / 4;
    pairs.forEach(([i, j], k) => {
      const sum = (a[i] + b[i] + c[i]) * (a[j] + b[j] + c[j]);
      second[k]! += (v * (a[i] * a[j] + b[i] * b[j] + c[i] * c[j] + sum)) / 20;
    });
  }
  if (!(volume > 1e-15)) return undefined;
  const centroid = first.map((value) => value / volume) as Vec3;
  const [xx, yy, zz, xy, xz, yz] = second.map((value, k) => {
    const [i, j] = pairs[k]!;
    return value - volume * centroid[i] * centroid[j];
  }) as Tensor;
  const inertia: Tensor = [yy + zz, xx + zz, xx + yy, -xy, -xz, -yz];
  return isPossible(inertia) ? { volume, centroid, inertia } : undefined;
}

/** No moment of a body is larger than the other two together, but for rounding: that of an open mesh may be. */
function isPossible(inertia: Tensor): boolean {
  const [small, middle, large] = principal(inertia).moments.sort((a, b) => a - b) as Vec3;
  return small > 0 && large <= (small + middle) * (1 + ROUNDING);
}

/** Of moments, as a share: a sheet's two small ones make its large one. */
const ROUNDING = 1e-6;

export function boundsOf(points: ArrayLike<number>): { min: Vec3; max: Vec3 } {
  const min: Vec3 = [Infinity, Infinity, Infinity];
  const max: Vec3 = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < points.length; i++) {
    const axis = i % 3;
    min[axis] = Math.min(min[axis]!, points[i]!);
    max[axis] = Math.max(max[axis]!, points[i]!);
  }
  return { min, max };
}

/** An open or inside-out mesh encloses no volume: its bounding box stands for it. */
function boundsSolid(points: number[]): Solid {
  const { min, max } = boundsOf(points);
  if (points.length === 0) return diagonal(0, 0, 0, 0);
  const size = max.map((value, i) => Math.max(value - min[i]!, 1e-6)) as Vec3;
  return { ...boxSolid(...size), centroid: max.map((value, i) => (value + min[i]!) / 2) as Vec3 };
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
  const mesh = tessellate(g);
  return meshSolid(mesh) ?? boundsSolid(mesh.points);
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
