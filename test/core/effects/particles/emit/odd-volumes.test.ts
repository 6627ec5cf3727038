import assert from 'node:assert/strict';
import { closedOf } from '../../../../../physics-core/effects/particles/emit/closed.js';
import { trianglesOf } from '../../../../../physics-core/effects/particles/emit/triangles.js';
import { volumeEmitter } from '../../../../../physics-core/effects/particles/emit/volume-emitter.js';
import type { Mesh } from '../../../../../physics-core/shapes/geometry.js';
import { tessellate } from '../../../../../physics-core/shapes/tessellate.js';
import { below, fact } from '../../../helpers.js';
import {
  apart,
  askew,
  birthsOf,
  blockMesh,
  insideOut,
  mapped,
  prism,
  U,
  within,
  type Block,
  type Vec3,
} from './laws.js';

const filled = (mesh: Mesh): ReturnType<typeof volumeEmitter> =>
  volumeEmitter({ mesh, internal: true, direction: [0, 1, 0], speed: 1, variation: 0 });

const BLOCK: Block = [
  [1, -2, 3],
  [2, 1, 3.5],
];
const block = blockMesh(BLOCK);

fact('a volume may be inside out, and its faces may have points of their own', () => {
  const { all } = birthsOf(filled(block), 1000);
  assert.deepEqual(birthsOf(filled(insideOut(block)), 1000).all, all);
  assert.deepEqual(birthsOf(filled(apart(block)), 1000).all, all);
});

/** A C: upward from within its lower arm, and from between its arms, a ray meets more than one face. */
const bent = mapped(prism(U, 0.7), ([x, y, z]) => [y, z, x]);

fact('faces of a volume may go round in different ways', () => {
  const other = insideOut(bent).index;
  const index = bent.index.map((value, i) => (i % 9 < 3 ? other[i]! : value));
  const { all } = birthsOf(filled(bent), 5000);
  assert.deepEqual(birthsOf(filled({ points: bent.points, index }), 5000).all, all);
});

fact('corners that rounding has set apart are one, and those of a gap are not', () => {
  const { points, index } = apart(block);
  const shaken = (by: number): { closed: boolean } =>
    closedOf(trianglesOf({ points: points.map((value, i) => value + by * ((i % 7) - 3)), index }));
  assert.equal(shaken(3e-6).closed, true);
  assert.equal(shaken(3e-4).closed, false);
});

fact('closed forms of X3D are closed, a ball with its poles, too', () => {
  for (const type of ['Box', 'Sphere', 'Cylinder', 'Cone', 'Torus'] as const) {
    const { points, index } = tessellate({ type });
    for (const list of [points, [...Float32Array.from(points)]]) {
      const found = closedOf(trianglesOf({ points: list, index }));
      assert.deepEqual(found, { closed: true, oriented: true });
    }
  }
});

fact('a plate askew is filled evenly and not beyond its faces, thick or thin', () => {
  for (const [thickness, count] of [
    [1, 5000],
    [0.02, 5000],
    [0.001, 100],
  ] as const) {
    const plate = blockMesh([
      [-1, -1, 0],
      [1, 1, thickness],
    ]);
    const births = birthsOf(filled(mapped(plate, askew)), count);
    const back = ([x, y, z]: Float64Array): Vec3 => [
      (2 * (x! - 10) + 2 * y! - z!) / 3,
      (-(x! - 10) + 2 * y! + 2 * z!) / 3,
      (2 * (x! - 10) - y! + 2 * z!) / 3,
    ];
    // Four standard deviations of a mean, of what has one of 1.
    const near = 4 / Math.sqrt(count);
    below(
      births.most((b) => Math.abs(back(b)[0])),
      1 + 1e-12,
    );
    below(
      births.most((b) => Math.abs(back(b)[2] / thickness - 0.5)),
      0.5 + 1e-9,
    );
    within(
      births.mean((b) => back(b)[0]),
      0,
      near * 0.6,
    );
    within(
      births.mean((b) => back(b)[0] ** 2),
      1 / 3,
      near * 0.3,
    );
    within(
      births.mean((b) => back(b)[2] / thickness),
      0.5,
      near * 0.3,
    );
  }
});
