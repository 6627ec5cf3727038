import assert from 'node:assert/strict';
import {
  polylineEmitter,
  type PolylineEmission,
} from '../../../../../physics-core/effects/particles/emit/polyline-emitter.js';
import { fact } from '../../../helpers.js';
import { birthsOf, follow, mixOf, offUnit, simplexLaw, within, type Vec3 } from './laws.js';

const direction: Vec3 = [0, 0, 2];
const POINTS = [0, 0, 0, 1, 0, 0, 1, 2, 0, 1, 2, 4, 5, -3, 1, 5, -3, 1.5];

const emission = (more: Partial<PolylineEmission> = {}): PolylineEmission => ({
  points: POINTS,
  index: [],
  direction,
  speed: 1,
  variation: 0,
  ...more,
});

const cornerAt = (i: number): Vec3 => POINTS.slice(3 * i, 3 * i + 3) as Vec3;

/** By length. */
const lawOf = (pairs: [number, number][]): ReturnType<typeof mixOf> =>
  mixOf(
    pairs.map(([i, j]) => {
      const [a, b] = [cornerAt(i), cornerAt(j)];
      const length = Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
      return [length, simplexLaw([a, b])];
    }),
  );

fact('a polyline emits evenly by length from all its segments, in its direction', () => {
  const births = birthsOf(polylineEmitter(emission({ index: [0, 1, 2, 3, -1] })));
  follow(
    births,
    lawOf([
      [0, 1],
      [1, 2],
      [2, 3],
    ]),
  );
  births.each((b) => assert.ok(b[3] === 0 && b[4] === 0 && b[5] === 1));
  // On one of them, that is.
  births.each(([x, y, z]) =>
    assert.ok((y === 0 && z === 0) || (x === 1 && z === 0) || (x === 1 && y === 2)),
  );
});

fact('where a line ends by -1 nothing is born on the way to the next', () => {
  const index = [0, 1, 2, -1, 4, 5, -1, -1, 3];
  const births = birthsOf(polylineEmitter(emission({ index })));
  follow(
    births,
    lawOf([
      [0, 1],
      [1, 2],
      [4, 5],
    ]),
  );
});

fact('without an index, or with a single -1, all points in order are one line', () => {
  const all = birthsOf(polylineEmitter(emission({ index: [0, 1, 2, 3, 4, 5] })), 1000).all;
  assert.deepEqual(birthsOf(polylineEmitter(emission({ index: [] })), 1000).all, all);
  assert.deepEqual(birthsOf(polylineEmitter(emission({ index: [-1] })), 1000).all, all);
});

fact('a segment without a length is passed over, and so is what is left of a point', () => {
  const emitter = polylineEmitter(emission({ index: [0, 0, 1, 1, 2, 2, -1, 4] }));
  follow(
    birthsOf(emitter),
    lawOf([
      [0, 1],
      [1, 2],
    ]),
  );
  const odd = polylineEmitter(emission({ points: [...POINTS, 7, 7] }));
  assert.deepEqual(birthsOf(odd, 10).all, birthsOf(polylineEmitter(emission()), 10).all);
});

fact('a line may go to and fro, and is then twice as long', () => {
  const births = birthsOf(polylineEmitter(emission({ index: [0, 1, 0, -1, 1, 2] })), 50_000);
  within(
    births.mean((b) => (b[1] === 0 ? 1 : 0)),
    0.5,
    0.005,
  );
});

fact('without a direction each particle of a polyline has another', () => {
  const births = birthsOf(polylineEmitter(emission({ direction: [0, 0, 0] })), 20_000);
  for (let i = 3; i < 6; i++)
    within(
      births.mean((b) => b[i]!),
      0,
      0.015,
    );
  assert.ok(births.most(offUnit) < 1e-15);
});
