import assert from 'node:assert/strict';
import { describe } from 'node:test';
import { below, fact } from '../../../../core/helpers.js';
import {
  farthest,
  hullCube,
  pyramid,
  stack,
  standing,
  wall,
  type Fields,
} from '../../../../core/effects/contact-solve/scenes.js';

// What stands upon each other stands still: how far anything moved in ten seconds, metres.

const cylinder = { type: 'Cylinder', radius: 0.5, height: 1 };

const SCENES: [says: string, all: Fields[], accuracy: string, bound: number][] = [
  ['ten boxes', stack(10), 'standard', 1e-3],
  ['twenty boxes', stack(20), 'standard', 1e-2],
  ['six boxes', stack(6), 'game', 1e-2],
  ['ten boxes of 5 cm', stack(10, 0.05), 'standard', 5e-4],
  ['thirty boxes of 5 cm', stack(30, 0.05), 'standard', 5e-4],
  ['five cylinders on end', stack(5, 1, () => ({ geometry: [cylinder] })), 'standard', 1e-2],
  ['ten cubes of faces', stack(10, 1, () => ({ geometry: [hullCube] })), 'standard', 1e-3],
  ['100 kg on 1 kg', stack(2, 1, (i) => ({ mass: 100 ** i })), 'standard', 1e-3],
  ['1000 kg on 1 kg', stack(2, 1, (i) => ({ mass: 1000 ** i })), 'standard', 1e-3],
  ['100 kg on five of 1 kg', stack(6, 1, (i) => ({ mass: i < 5 ? 1 : 100 })), 'standard', 1e-3],
  ['ten boxes, each twice as heavy', stack(10, 1, (i) => ({ mass: 2 ** i })), 'standard', 1e-3],
  ['a pyramid of ten rows', pyramid(10), 'standard', 1e-3],
  ['five rows of bricks with joints of 1 mm', wall(5, 6, 1e-3), 'standard', 1e-3],
  ['ten rows of bricks without joints', wall(10, 10, 0), 'standard', 1e-3],
];

describe('in ten seconds', () => {
  for (const [says, all, accuracy, bound] of SCENES)
    fact(`${says} move by less than ${1000 * bound} mm at ${accuracy}`, async () => {
      below(farthest(await standing(all, { accuracy }), 10), bound, 'm');
    });
});

const ASLEEP: [says: string, all: Fields[]][] = [
  ['five boxes', stack(5)],
  ['ten boxes', stack(10)],
  ['twenty boxes', stack(20)],
  ['five cylinders on end', stack(5, 1, () => ({ geometry: [cylinder] }))],
  ['ten cubes of faces', stack(10, 1, () => ({ geometry: [hullCube] }))],
  ['100 kg on 1 kg', stack(2, 1, (i) => ({ mass: 100 ** i }))],
  ['a pyramid of ten rows', pyramid(10)],
];

describe('where bodies may rest', () => {
  for (const [says, all] of ASLEEP)
    fact(`${says} sleep within three seconds`, async () => {
      const { w, bodies } = await standing(all, { rest: 'auto' });
      w.advance(3);
      for (const body of bodies) assert.ok(body.sleeping);
    });
});
