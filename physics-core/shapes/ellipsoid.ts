// A Sphere that is scaled or sheared: exact where its triangles would only be near.
import { EllipsoidForm } from './forms/ellipsoid.js';
import { THINNEST } from './build.js';
import type { Geometry } from './geometry.js';
import { principal, type Solid, type Tensor } from './mass.js';

/** A Aᵀ of the map A that makes it of the unit ball: its squares along and across the axes. Undefined: no sphere, or flat. */
export function squaresOf(g: Geometry): Tensor | undefined {
  if (g.type !== 'Sphere' || !g.linear) return undefined;
  const map = g.linear.map((value) => value * (g.radius ?? 1));
  const at = (i: number, j: number): number =>
    map[3 * i]! * map[3 * j]! +
    map[3 * i + 1]! * map[3 * j + 1]! +
    map[3 * i + 2]! * map[3 * j + 2]!;
  const squares: Tensor = [at(0, 0), at(1, 1), at(2, 2), at(0, 1), at(0, 2), at(1, 2)];
  return Math.min(...principal(squares).moments) > THINNEST ** 2 ? squares : undefined;
}

export const ellipsoidForm = (squares: Tensor): EllipsoidForm =>
  new EllipsoidForm(squares, Math.sqrt(Math.max(...principal(squares).moments)));

export function ellipsoidSolid(squares: Tensor): Solid {
  const [x, y, z] = principal(squares).moments;
  const volume = (4 / 3) * Math.PI * Math.sqrt(x * y * z);
  const [xx, yy, zz, xy, xz, yz] = squares.map((square) => (volume / 5) * square) as Tensor;
  return { volume, centroid: [0, 0, 0], inertia: [yy + zz, xx + zz, xx + yy, -xy, -xz, -yz] };
}
