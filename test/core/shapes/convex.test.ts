import { isConvex } from '../../../physics-core/shapes/convex.js';
import { hullOf } from '../../../physics-core/shapes/hull.js';
import { tessellate } from '../../../physics-core/shapes/tessellate.js';
import type { Mesh } from '../../../physics-core/shapes/geometry.js';
import { quaternionOf, rotate } from '../../../physics-core/base/math.js';
import { meshes } from '../../../physics-core/shapes/meshes.js';
import assert from 'node:assert/strict';
import { fact } from '../helpers.js';

await meshes.load();

/** A cube of 2 m with each face divided into `n` by `n`. */
function divided(n: number): Mesh {
  const [points, index] = [[] as number[], [] as number[]];
  for (const axis of [0, 1, 2])
    for (const side of [-1, 1]) {
      const first = points.length / 3;
      for (let i = 0; i <= n; i++)
        for (let j = 0; j <= n; j++) {
          const point = [0, 0, 0];
          point[axis] = side;
          point[(axis + 1) % 3] = (2 * i) / n - 1;
          point[(axis + 2) % 3] = (2 * j) / n - 1;
          points.push(...point);
          if (i === n || j === n) continue;
          const a = first + i * (n + 1) + j;
          const [b, c, d] = [a + n + 1, a + n + 2, a + 1];
          index.push(...(side > 0 ? [a, b, c, a, c, d] : [a, c, b, a, d, c]));
        }
    }
  return { points, index };
}

/** Turned any which way and moved, and what a number type makes of it. */
const as = ({ points, index }: Mesh, at: number, round: (x: number) => number): Mesh => ({
  index,
  points: Array.from({ length: points.length / 3 }, (_, i) =>
    rotate(quaternionOf([0.3, 0.5, -0.8, 1.1]), [
      points[3 * i]!,
      points[3 * i + 1]!,
      points[3 * i + 2]!,
    ]),
  ).flatMap(([x, y, z]) => [round(x + at), round(y - 0.7 * at), round(z + 0.3 * at)]),
});

const convex = (mesh: Mesh): boolean => isConvex(mesh, hullOf(mesh.points));

const MESHES: [string, Mesh][] = [
  ['a sphere', tessellate({ type: 'Sphere' })],
  ['a cylinder', tessellate({ type: 'Cylinder' })],
  ['a cone', tessellate({ type: 'Cone' })],
  ['a cube of 3072 triangles', divided(16)],
];

fact('a convex mesh is one in single precision, too, ten metres from its origin', () => {
  for (const [name, mesh] of MESHES) assert.ok(convex(as(mesh, 10, Math.fround)), name);
});

fact('a convex mesh is one with six decimals in its file, too', () => {
  for (const [name, mesh] of MESHES)
    assert.ok(convex(as(mesh, 0, (x) => Number(x.toFixed(6)))), name);
});

fact('a dent of a ten-thousandth of its size makes a mesh concave', () => {
  const mesh = divided(16);
  // In the middle of the first face.
  mesh.points[(8 * 17 + 8) * 3]! += 1e-4 * Math.hypot(2, 2, 2);
  assert.ok(!convex(mesh));
});

fact('a mesh that faces inward is concave, and a flat one is convex from both sides', () => {
  const cube = divided(16);
  assert.ok(!convex({ ...cube, index: cube.index.toReversed() }));
  const sheet = tessellate({ type: 'Rectangle2D' });
  assert.ok(convex(sheet));
  assert.ok(convex({ ...sheet, index: [...sheet.index, ...sheet.index.toReversed()] }));
});
