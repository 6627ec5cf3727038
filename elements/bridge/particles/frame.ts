import type { Binding } from '../nodes/binding.js';
import { nodesOf, placesOf } from '../document/structure.js';
import { standInMatrix } from '../document/shortcuts.js';
import { decompose, identity, multiply, type Affine } from '../geometry/matrix.js';
import { localMatrix, transformsAbove } from '../scopes/transforms.js';

/** Where a ParticleSystem stands. */
export interface Frame {
  /** What carries it. */
  body: Binding | undefined;
  /** From its own frame to that of the body, else of the world, in the lengths that x3dom draws. */
  matrix: Affine;
}

/** By its field `body`; else the first body that moves a Transform above it. `user` is told of edits of these Transforms. */
export function frameOf(system: Binding, user = system): Frame {
  const { drivers, readers } = system.scene!;
  const [named] = nodesOf(system, 'body', 'RigidBody');
  if (named) return { body: named, matrix: identity() };
  let matrix = identity();
  for (const transform of transformsAbove(placesOf(system)[0] ?? system.element, system.scope!)) {
    readers.add(transform, user);
    const body = drivers.of(transform);
    if (body) return { body, matrix: multiply(scaleOf(body), matrix) };
    matrix = multiply(localMatrix(transform), matrix);
  }
  return { body: undefined, matrix };
}

/** What a body's Transform has beside the pose of the body. */
function scaleOf({ standIn }: Binding): Affine {
  const linear = standIn && decompose(standInMatrix(standIn)).linear;
  if (!linear) return identity();
  const [a, b, c, d, e, f, g, h, i] = linear;
  return [a, b, c, 0, d, e, f, 0, g, h, i, 0];
}

/** How much longer things are in the world. */
export function scaleIn([a, b, c, , d, e, f, , g, h, i]: Affine): number {
  const volume = a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g);
  return Math.cbrt(Math.abs(volume));
}

/** A point, or a way where `w` is 0. */
export const mapped = (m: Affine, [x, y, z]: number[], w: number): number[] =>
  [0, 4, 8].map((row) => m[row] * x + m[row + 1] * y + m[row + 2] * z + m[row + 3] * w);
