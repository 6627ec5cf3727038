import assert from 'node:assert/strict';
import { Draws } from '../../../../../physics-core/effects/particles/emit/draws.js';
import { BIRTH } from '../../../../../physics-core/effects/particles/emit/emitter.js';
import { surfaceEmitter } from '../../../../../physics-core/effects/particles/emit/surface-emitter.js';
import {
  volumeEmitter,
  type VolumeEmission,
} from '../../../../../physics-core/effects/particles/emit/volume-emitter.js';
import type { Mesh } from '../../../../../physics-core/shapes/geometry.js';
import { tessellate } from '../../../../../physics-core/shapes/tessellate.js';
import { below, fact } from '../../../helpers.js';
import {
  askew,
  birthsOf,
  blockLaw,
  blockMesh,
  follow,
  mapped,
  mixOf,
  offUnit,
  prism,
  U,
  within,
  type Block,
  type Vec3,
} from './laws.js';

const direction: Vec3 = [0, 2, 0];
const filled = (mesh: Mesh, more: Partial<VolumeEmission> = {}): ReturnType<typeof volumeEmitter> =>
  volumeEmitter({ mesh, internal: true, direction, speed: 1, variation: 0, ...more });

const BLOCK: Block = [
  [1, -2, 3],
  [2, 1, 3.5],
];
const block = blockMesh(BLOCK);

fact('a box is filled evenly, and left in its direction', () => {
  const births = birthsOf(filled(blockMesh(BLOCK)));
  follow(births, blockLaw(BLOCK)[1]);
  births.each((b) => {
    for (let i = 0; i < 3; i++) assert.ok(b[i]! >= BLOCK[0][i]! && b[i]! <= BLOCK[1][i]!);
    assert.ok(b[3] === 0 && b[4] === 1 && b[5] === 0);
  });
});

fact('each part of a box has its share, along the lines between its triangles, too', () => {
  const parts = new Array<number>(36).fill(0);
  const count = 72_000;
  birthsOf(filled(block), count).each(([x, y]) => {
    parts[Math.floor(6 * (x! - 1)) * 6 + Math.floor(2 * (y! + 2))]!++;
  });
  // Four standard deviations are 9 %.
  for (const part of parts) within(part / (count / 36), 1, 0.09, 'part');
});

const U_LAW = mixOf([
  blockLaw([
    [0, 0, 0],
    [3, 1, 0.7],
  ]),
  blockLaw([
    [0, 1, 0],
    [1, 2, 0.7],
  ]),
  blockLaw([
    [2, 1, 0],
    [3, 2, 0.7],
  ]),
]);

fact('a solid may be bent: a U is filled evenly, and nothing is born between its arms', () => {
  const births = birthsOf(filled(prism(U, 0.7)));
  follow(births, U_LAW);
  assert.equal(
    births.most(([x, y]) => (x! > 1 && x! < 2 && y! > 1 ? 1 : 0)),
    0,
  );
});

fact('a volume that is not internal emits from its surface, in its direction', () => {
  const births = birthsOf(filled(block, { internal: false }), 2000);
  const surface = birthsOf(surfaceEmitter({ mesh: block, speed: 1, variation: 0 }), 2000);
  for (let at = 0; at < births.all.length; at += BIRTH) {
    assert.deepEqual(births.all.subarray(at, at + 3), surface.all.subarray(at, at + 3));
    assert.deepEqual([...births.all.subarray(at + 3, at + 6)], [0, 1, 0]);
  }
});

fact('without a direction each particle of a volume has another, inside and on its surface', () => {
  for (const internal of [true, false]) {
    const births = birthsOf(filled(block, { internal, direction: [0, 0, 0] }), 10_000);
    for (let i = 3; i < 6; i++)
      within(
        births.mean((b) => b[i]!),
        0,
        0.02,
      );
    below(births.most(offUnit), 1e-15);
  }
});

const isNone = (mesh: Mesh): void => {
  for (const internal of [true, false])
    assert.equal(filled(mesh, { internal }).emit(new Draws(1), new Float64Array(BIRTH)), false);
};

fact('from an open mesh nothing is born', () => {
  isNone({ points: block.points, index: block.index.slice(3) });
  isNone(tessellate({ type: 'Cylinder', top: false }));
  isNone(tessellate({ type: 'Rectangle2D' }));
  isNone({ points: [], index: [] });
});

fact('within a box without height, and within two faces back to back, nothing is born', () => {
  const flat = blockMesh([
    [0, 0, 1],
    [1, 1, 1],
  ]);
  for (const mesh of [flat, mapped(flat, askew)])
    assert.equal(filled(mesh).emit(new Draws(1), new Float64Array(BIRTH)), false);
});
