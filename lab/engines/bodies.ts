import type { CaseBody, CaseScene, Heights, Vec3 } from '../case.js';
import { add, quaternionOf, type Pose } from '../../physics-core/base/math.js';

export const massOf = ({ mass = 1 }: CaseBody): number => mass;

/** Where a body starts. */
export const poseOf = ({ position = [0, 0, 0], orientation = [0, 0, 1, 0] }: CaseBody): Pose => ({
  p: position,
  q: quaternionOf(orientation),
});

/** Where its author has a body after so many seconds; none of what nobody moves. */
export function guideOf(body: CaseBody): ((time: number) => Pose) | undefined {
  const { path, turn } = body;
  if (!path && !turn) return undefined;
  const { p, q } = poseOf(body);
  return (time) => ({ p: path ? path(time) : p, q: turn ? quaternionOf(turn(time)) : q });
}

const sum = (vectors: readonly Vec3[] = []): Vec3 => vectors.reduce<Vec3>(add, [0, 0, 0]);

export const forceOn = ({ forces }: CaseBody): Vec3 => sum(forces);
export const torqueOn = ({ torques }: CaseBody): Vec3 => sum(torques);

/** Of the solid shape about its own axes, kg m², unless the case gives them. */
export function momentsOf(body: CaseBody): Vec3 {
  const { inertia, shape } = body;
  if (inertia) return inertia;
  const m = massOf(body);
  if (!shape) throw new Error(`${body.name} has neither shape nor inertia`);
  if (shape.type === 'IndexedTriangleSet' || shape.type === 'ElevationGrid')
    throw new Error(`${body.name} needs an inertia`);
  if (shape.type === 'Sphere') return Array<number>(3).fill(0.4 * m * shape.radius ** 2) as Vec3;
  if (shape.type === 'Box') {
    const [x, y, z] = shape.size.map((length) => length ** 2) as Vec3;
    return [(m / 12) * (y + z), (m / 12) * (x + z), (m / 12) * (x + y)];
  }
  const { radius, height } = shape;
  const across = (m / 12) * (3 * radius ** 2 + height ** 2);
  return [across, 0.5 * m * radius ** 2, across];
}

export const isRound = (body: CaseBody): boolean => {
  const [x, y, z] = momentsOf(body);
  return Math.max(x, y, z) - Math.min(x, y, z) <= 1e-9 * x;
};

/** Of a grid, from its corner; most engines take that for where it is. */
export const middleOf = ({ xDimension, zDimension, xSpacing, zSpacing }: Heights): Vec3 => [
  ((xDimension - 1) * xSpacing) / 2,
  0,
  ((zDimension - 1) * zSpacing) / 2,
];

/** What is convex where it moves, and where it does not may have any form. */
export const isHull = ({ shape, fixed }: CaseBody): boolean =>
  shape?.type === 'IndexedTriangleSet' && !fixed;

/** Corners of triangles, one after the other. */
export const cornersOf = (coord: readonly number[]): Vec3[] =>
  Array.from({ length: coord.length / 3 }, (_, i) => coord.slice(3 * i, 3 * i + 3) as Vec3);

export function bodyNamed(scene: CaseScene, name: string): CaseBody {
  const body = scene.bodies.find((one) => one.name === name);
  if (!body) throw new Error(`the scene has no body ${name}`);
  return body;
}
