import assert from 'node:assert/strict';
import { Draws } from '../../../../../physics-core/effects/particles/emit/draws.js';
import { coneEmitter } from '../../../../../physics-core/effects/particles/emit/cone-emitter.js';
import { BIRTH, type Emitter } from '../../../../../physics-core/effects/particles/emit/emitter.js';
import { explosionEmitter } from '../../../../../physics-core/effects/particles/emit/explosion-emitter.js';
import { pointEmitter } from '../../../../../physics-core/effects/particles/emit/point-emitter.js';
import { polylineEmitter } from '../../../../../physics-core/effects/particles/emit/polyline-emitter.js';
import { surfaceEmitter } from '../../../../../physics-core/effects/particles/emit/surface-emitter.js';
import { volumeEmitter } from '../../../../../physics-core/effects/particles/emit/volume-emitter.js';
import { tessellate } from '../../../../../physics-core/shapes/tessellate.js';
import { fact } from '../../../helpers.js';
import { birthsOf, type Vec3 } from './laws.js';

const speeds = { speed: 2, variation: 0.25 };
const position: Vec3 = [1, 2, 3];
const direction: Vec3 = [0, 0, 0];
const mesh = tessellate({ type: 'Cone' });
const points = [0, 0, 0, 1, 2, 3, -1, 0, 2];

const EMITTERS: Record<string, Emitter> = {
  point: pointEmitter({ position, direction, ...speeds }),
  cone: coneEmitter({ position, direction: [1, 2, 2], angle: 1, ...speeds }),
  explosion: explosionEmitter({ position, ...speeds }),
  polyline: polylineEmitter({ points, index: [], direction, ...speeds }),
  surface: surfaceEmitter({ mesh, ...speeds }),
  volume: volumeEmitter({ mesh, internal: true, direction, ...speeds }),
  skin: volumeEmitter({ mesh, internal: false, direction, ...speeds }),
};

for (const [name, emitter] of Object.entries(EMITTERS)) {
  fact(`what a ${name} emits is the same bits for the same seed, and others for another`, () => {
    const { all } = birthsOf(emitter, 200, 5);
    assert.deepEqual(birthsOf(emitter, 200, 5).all, all);
    const other = birthsOf(emitter, 200, 6).all;
    for (let n = 0; n < 200; n++)
      assert.notDeepEqual(
        other.subarray(n * BIRTH + 3, n * BIRTH + 6),
        all.subarray(n * BIRTH + 3, n * BIRTH + 6),
      );
  });

  fact(`in whatever order particles of a ${name} are asked for, each is born alike`, () => {
    const { all } = birthsOf(emitter, 100, 5);
    const draws = new Draws(5);
    const birth = new Float64Array(BIRTH);
    for (let n = 99; n >= 0; n -= 3) {
      draws.of(n + 7, 2).next();
      emitter.emit(draws.of(n), birth);
      assert.deepEqual(birth, all.subarray(n * BIRTH, (n + 1) * BIRTH));
    }
  });

  fact(`births of a ${name} are numbers, and it tells that there are some`, () => {
    assert.ok(birthsOf(emitter, 2000).all.every(Number.isFinite));
  });
}

const isNone = (emitter: Emitter): void => {
  const draws = new Draws(1);
  const birth = new Float64Array(BIRTH);
  for (let n = 0; n < 10; n++) assert.equal(emitter.emit(draws.of(n), birth), false);
  assert.deepEqual(birth, new Float64Array(BIRTH));
};

fact('with a number that is none, or without end, nothing is born', () => {
  for (const bad of [NaN, Infinity]) {
    const nowhere: Vec3 = [0, bad, 0];
    isNone(pointEmitter({ position: nowhere, direction, ...speeds }));
    isNone(pointEmitter({ position, direction: nowhere, ...speeds }));
    isNone(pointEmitter({ position, direction, speed: bad, variation: 0 }));
    isNone(pointEmitter({ position, direction, speed: 1, variation: bad }));
    isNone(pointEmitter({ position, direction, speed: 1e308, variation: 1 }));
    isNone(coneEmitter({ position: nowhere, direction, angle: 1, ...speeds }));
    isNone(coneEmitter({ position, direction: nowhere, angle: 1, ...speeds }));
    isNone(coneEmitter({ position, direction, angle: bad, ...speeds }));
    isNone(explosionEmitter({ position: nowhere, ...speeds }));
    isNone(polylineEmitter({ points, index: [], direction: nowhere, ...speeds }));
    isNone(polylineEmitter({ points: [...points, bad, 0, 0], index: [], direction, ...speeds }));
    const marred = {
      points: mesh.points.map((value, i) => (i === 4 ? bad : value)),
      index: mesh.index,
    };
    isNone(surfaceEmitter({ mesh: marred, ...speeds }));
    isNone(surfaceEmitter({ mesh, speed: bad, variation: 0 }));
    isNone(volumeEmitter({ mesh: marred, internal: true, direction, ...speeds }));
    isNone(volumeEmitter({ mesh, internal: true, direction: nowhere, ...speeds }));
  }
});

fact('along a line that is none, or has no length, nothing is born', () => {
  const none = (list: number[], index: number[]): void =>
    isNone(polylineEmitter({ points: list, index, direction, ...speeds }));
  none([], []);
  none([1, 2, 3], []);
  none([1, 2, 3, 1, 2, 3], []);
  none(points, [0]);
  none(points, [0, -1, 1, -1, 2]);
  none(points, [-1, -1]);
  for (const amiss of [3, -2, 0.5, 1 / 3, NaN, 1e9]) none(points, [0, 1, amiss]);
});

fact('on triangles that are none, or have no area, nothing is born', () => {
  const none = (list: number[], index: number[]): void => {
    isNone(surfaceEmitter({ mesh: { points: list, index }, ...speeds }));
    isNone(volumeEmitter({ mesh: { points: list, index }, internal: true, direction, ...speeds }));
    isNone(volumeEmitter({ mesh: { points: list, index }, internal: false, direction, ...speeds }));
  };
  none([], []);
  none(points, []);
  none(points, [0, 1]);
  none(points, [0, 1, 1]);
  none([0, 0, 0, 1, 1, 1, 2, 2, 2], [0, 1, 2]);
  for (const amiss of [3, -1, 0.5, 1 / 3, NaN, 1e9]) none(points, [0, 1, 2, 0, 1, amiss]);
});

fact('numbers of a line that no index names may be anything', () => {
  const emitter = polylineEmitter({
    points: [...points, NaN, 0, 0],
    index: [0, 1],
    direction,
    ...speeds,
  });
  assert.ok(birthsOf(emitter, 10).all.every(Number.isFinite));
});

fact('what is left of a point or of a triangle is passed over', () => {
  const longer = { points: [...mesh.points, 7, 7], index: [...mesh.index, 0, 1] };
  for (const internal of [true, false]) {
    const of = (shape: typeof mesh): Float64Array =>
      birthsOf(volumeEmitter({ mesh: shape, internal, direction, ...speeds }), 10).all;
    assert.deepEqual(of(longer), of(mesh));
  }
  isNone(surfaceEmitter({ mesh: { ...longer, index: [mesh.points.length / 3, 0, 1] }, ...speeds }));
});
