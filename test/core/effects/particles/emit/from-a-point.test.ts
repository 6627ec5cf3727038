import assert from 'node:assert/strict';
import { coneEmitter } from '../../../../../physics-core/effects/particles/emit/cone-emitter.js';
import { explosionEmitter } from '../../../../../physics-core/effects/particles/emit/explosion-emitter.js';
import { pointEmitter } from '../../../../../physics-core/effects/particles/emit/point-emitter.js';
import { above, below, fact } from '../../../helpers.js';
import { birthsOf, offUnit, SHARE, speedOf, within, type Births, type Vec3 } from './laws.js';

const position: Vec3 = [1, -2, 3];
const steady = { position, speed: 1, variation: 0 };
/** Of chance, for what is spread over all directions and as many as are drawn here: half of it. */
const NEAR = 0.012;
const SOME = 30_000;

const alongOf = (births: Births, axis: Vec3): number =>
  births.mean((b) => b[3]! * axis[0] + b[4]! * axis[1] + b[5]! * axis[2]);

function isAllAround(births: Births): void {
  below(births.most(offUnit), 1e-15);
  for (let i = 3; i < 6; i++) {
    within(
      births.mean((b) => b[i]!),
      0,
      NEAR,
      `mean ${i}`,
    );
    for (let j = 3; j <= i; j++) {
      const law = i === j ? 1 / 3 : 0;
      within(
        births.mean((b) => b[i]! * b[j]!),
        law,
        0.005,
        `second ${i} ${j}`,
      );
    }
  }
  // A belt of a sphere has the area of its height (Archimedes): as many in each tenth.
  const belts = new Array<number>(10).fill(0);
  births.each((b) => belts[Math.floor(5 * (b[4]! + 1))]!++);
  for (const belt of belts) within(belt / SOME, 0.1, 0.006, 'belt');
}

fact('a point emits from its place in its direction, however long that is', () => {
  for (const length of [1e-200, 1, 2.9e307]) {
    const direction = [2, -3, 6].map((value) => value * length) as Vec3;
    const births = birthsOf(pointEmitter({ ...steady, direction, speed: 7 }), 3);
    births.each((b) => {
      assert.deepEqual([...b.subarray(0, 3)], position);
      [2, -3, 6].forEach((value, i) => within(b[3 + i]!, value, 1e-14));
    });
  }
});

fact('a point without a direction emits all around', () => {
  isAllAround(birthsOf(pointEmitter({ ...steady, direction: [0, 0, 0] }), SOME));
});

fact('an explosion emits from its place all around', () => {
  const births = birthsOf(explosionEmitter(steady), SOME);
  isAllAround(births);
  births.each((b) => assert.ok(b[0] === 1 && b[1] === -2 && b[2] === 3));
});

fact('a cone without a direction, and one of a half turn, emit all around', () => {
  isAllAround(birthsOf(coneEmitter({ ...steady, direction: [0, 0, 0], angle: 0.1 }), SOME));
  const births = birthsOf(coneEmitter({ ...steady, direction: [3, 1, -2], angle: Math.PI }), SOME);
  isAllAround(births);
});

fact('a cone is filled by solid angle: the mean share of its axis is (1 + cos) / 2', () => {
  const direction: Vec3 = [3, -2, 6];
  const axis: Vec3 = [3 / 7, -2 / 7, 6 / 7];
  for (const angle of [0.1, 0.7854, 1.5708, 2.5]) {
    const births = birthsOf(coneEmitter({ ...steady, direction, angle }), SOME);
    const cos = Math.cos(angle);
    below(births.most(offUnit), 1e-15);
    const along = (b: Float64Array): number => (b[3]! * 3 - b[4]! * 2 + b[5]! * 6) / 7;
    below(
      births.most((b) => -along(b)),
      -cos + 1e-12,
    );
    within(alongOf(births, axis), (1 + cos) / 2, NEAR * (1 - cos) * 0.5, 'axis');
    // The height on the axis is even from cos to 1.
    const about = births.mean((b) => (along(b) - (1 + cos) / 2) ** 2);
    within(about / ((1 - cos) ** 2 / 12), 1, SHARE, 'variance');
  }
});

fact('a cone is round: no direction across its axis is before another', () => {
  const angle = 1;
  const births = birthsOf(coneEmitter({ ...steady, direction: [0, 0, -2], angle }));
  const cos = Math.cos(angle);
  const half = (1 - (1 + cos + cos * cos) / 3) / 2;
  within(
    births.mean((b) => b[3]! * b[3]!),
    half,
    SHARE * half,
  );
  within(
    births.mean((b) => b[4]! * b[4]!),
    half,
    SHARE * half,
  );
  within(
    births.mean((b) => b[3]! * b[4]!),
    0,
    SHARE * half,
  );
  within(
    births.mean((b) => b[3]!),
    0,
    0.02 * Math.sqrt(half),
  );
});

fact('a cone of a billionth of a radian is still filled, and one of none is its axis', () => {
  const needle = birthsOf(coneEmitter({ ...steady, direction: [0, 1, 0], angle: 1e-9 }), SOME);
  const across = needle.mean((b) => b[3]! ** 2 + b[5]! ** 2);
  within(across / 1e-18, 0.5, 0.5 * SHARE);
  const axis = birthsOf(coneEmitter({ ...steady, direction: [0, 5, 0], angle: 0 }), 10);
  axis.each((b) => assert.ok(b[3] === 0 && b[4] === 1 && b[5] === 0));
});

fact('angles out of their range are the nearest in it', () => {
  const direction: Vec3 = [1, 2, 3];
  const of = (angle: number): Float64Array =>
    birthsOf(coneEmitter({ ...steady, direction, angle }), 10).all;
  assert.deepEqual(of(-1), of(0));
  assert.deepEqual(of(4), of(Math.PI));
});

fact('speeds are even from less to more by the variation', () => {
  const births = birthsOf(explosionEmitter({ position, speed: 8, variation: 0.25 }));
  within(births.mean(speedOf), 8, 8 * SHARE);
  within(
    births.mean((b) => (speedOf(b) - 8) ** 2),
    4 / 3,
    (4 / 3) * SHARE,
  );
  below(births.most(speedOf), 10);
  above(births.most(speedOf), 9.99);
  below(
    births.most((b) => -speedOf(b)),
    -6,
  );
});

fact('a speed below 0 is 0: with a variation of 2 a quarter stand', () => {
  const births = birthsOf(explosionEmitter({ position, speed: 1, variation: 2 }), SOME);
  within(births.mean(speedOf), 9 / 8, (9 / 8) * SHARE);
  within(
    births.mean((b) => (speedOf(b) === 0 ? 1 : 0)),
    0.25,
    0.01,
  );
  const back = birthsOf(explosionEmitter({ position, speed: -1, variation: 0.5 }), 10);
  assert.equal(back.most(speedOf), 0);
});

fact('how fast one is says nothing of where it goes', () => {
  const births = birthsOf(explosionEmitter({ position, speed: 1, variation: 1 }), SOME);
  for (let i = 3; i < 6; i++) {
    const cos = births.mean((b) => (speedOf(b) - 1) * (b[i]! / (speedOf(b) || 1)));
    within(cos, 0, 0.006);
  }
});
