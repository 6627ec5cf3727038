import assert from 'node:assert/strict';
import { surfaceEmitter } from '../../../../../physics-core/effects/particles/emit/surface-emitter.js';
import { tessellate } from '../../../../../physics-core/shapes/tessellate.js';
import { below, fact } from '../../../helpers.js';
import {
  birthsOf,
  follow,
  insideOut,
  mixOf,
  offUnit,
  simplexLaw,
  within,
  type Vec3,
} from './laws.js';

const steady = { speed: 1, variation: 0 };
/** A triangle in the plane z = 1, of area 3, and one in x = 4, of area 1. */
const CORNERS: Vec3[] = [
  [0, 0, 1],
  [3, 0, 1],
  [1, 2, 1],
  [4, 0, 0],
  [4, 2, 0],
  [4, 0, 1],
];
const mesh = { points: CORNERS.flat(), index: [0, 1, 2, 3, 4, 5] };

fact('a surface emits evenly by area from all its triangles', () => {
  const law = mixOf([
    [3, simplexLaw(CORNERS.slice(0, 3))],
    [1, simplexLaw(CORNERS.slice(3))],
  ]);
  follow(birthsOf(surfaceEmitter({ mesh, ...steady })), law);
});

fact('within one triangle, too, places are even, and none is outside', () => {
  const births = birthsOf(surfaceEmitter({ mesh: { ...mesh, index: [0, 1, 2] }, ...steady }));
  follow(births, simplexLaw(CORNERS.slice(0, 3)));
  births.each(([x, y, z]) =>
    assert.ok(z === 1 && y! >= 0 && y! <= 2 * x! + 1e-12 && x! + y! <= 3 + 1e-12),
  );
});

fact('a surface is left along the normal that sees its corners go round counter-clockwise', () => {
  const births = birthsOf(surfaceEmitter({ mesh, ...steady }), 1000);
  births.each((b) =>
    assert.deepEqual([...b.subarray(3)], b[2] === 1 && b[0] !== 4 ? [0, 0, 1] : [1, 0, 0]),
  );
  const turned = birthsOf(surfaceEmitter({ mesh: insideOut(mesh), ...steady }), 1000);
  turned.each((b) => assert.equal(b[3]! + b[4]! + b[5]!, -1));
});

fact('they leave a ball outward, with the speed that is drawn for each', () => {
  const ball = tessellate({ type: 'Sphere', radius: 2 });
  const births = birthsOf(surfaceEmitter({ mesh: ball, ...steady }), 20_000);
  below(births.most(offUnit), 1e-15);
  below(
    births.most((b) => -(b[0]! * b[3]! + b[1]! * b[4]! + b[2]! * b[5]!)),
    -1.97,
  );
  for (let i = 0; i < 3; i++)
    within(
      births.mean((b) => b[i]!),
      0,
      0.03,
    );
  const fast = birthsOf(surfaceEmitter({ mesh: ball, speed: 5, variation: 0.5 }), 20_000);
  within(
    fast.mean((b) => Math.hypot(b[3]!, b[4]!, b[5]!)),
    5,
    0.05,
  );
});

fact('a triangle without an area is passed over', () => {
  const index = [0, 0, 1, 0, 1, 2, 3, 3, 3];
  const births = birthsOf(surfaceEmitter({ mesh: { ...mesh, index }, ...steady }), 1000);
  births.each((b) => assert.equal(b[5], 1));
});
