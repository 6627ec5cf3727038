import type { Vec3 } from '../fields/types.js';
import { boundsOf } from './bounds.js';
import { ellipsoidSolid, squaresOf } from './ellipsoid.js';
import type { Geometry, Mesh } from './geometry.js';
import { boxSolid, diagonal, principal, type Solid, type Tensor } from './mass.js';
import { tessellate } from './tessellate.js';

/** The solid that the triangles of a geometry enclose; of a ball that is scaled, the ellipsoid. */
export function meshSolidOf(g: Geometry): Solid {
  const squares = squaresOf(g);
  if (squares) return ellipsoidSolid(squares);
  const mesh = tessellate(g);
  return meshSolid(mesh) ?? boundsSolid(mesh.points);
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

/** An open or inside-out mesh encloses no volume: its bounding box stands for it. */
function boundsSolid(points: number[]): Solid {
  const { min, max } = boundsOf(points);
  if (points.length === 0) return diagonal(0, 0, 0, 0);
  const size = max.map((value, i) => Math.max(value - min[i]!, 1e-6)) as Vec3;
  return { ...boxSolid(...size), centroid: max.map((value, i) => (value + min[i]!) / 2) as Vec3 };
}
