import { describe } from 'node:test';
import { below, fact } from '../../../../core/helpers.js';
import {
  arch,
  cards,
  farthest,
  hullCube,
  pyramid,
  stack,
  standing,
  wall,
  type Fields,
} from '../../../../core/effects/contact-solve/scenes.js';

// What stands upon each other stands still for a minute, metres.

const cylinder = { type: 'Cylinder', radius: 0.5, height: 1 };

const SCENES: [says: string, all: Fields[], accuracy: string, bound: number][] = [
  ['five boxes', stack(5), 'game', 1e-3],
  ['ten boxes', stack(10), 'game', 1e-3],
  ['ten boxes', stack(10), 'standard', 1e-3],
  ['twenty boxes', stack(20), 'standard', 1e-3],
  ['ten boxes of 5 cm', stack(10, 0.05), 'standard', 5e-4],
  ['ten cylinders on end', stack(10, 1, () => ({ geometry: [cylinder] })), 'standard', 1e-3],
  ['ten cubes of faces', stack(10, 1, () => ({ geometry: [hullCube] })), 'standard', 1e-3],
  ['1000 kg on 1 kg', stack(2, 1, (i) => ({ mass: 1000 ** i })), 'standard', 1e-3],
  ['100 kg on five of 1 kg', stack(6, 1, (i) => ({ mass: i < 5 ? 1 : 100 })), 'standard', 1e-3],
  ['ten boxes, each twice as heavy', stack(10, 1, (i) => ({ mass: 2 ** i })), 'standard', 1e-3],
  ['a pyramid of ten rows', pyramid(10), 'standard', 1e-3],
  ['five rows of bricks with joints of 1 mm', wall(5, 6, 1e-3), 'standard', 1e-3],
  ['a card house of three storeys', cards(), 'standard', 2e-3],
  ['a card house of three storeys', cards(), 'fine', 1e-3],
  ['an arch of 13 wedges', arch(13), 'standard', 1e-3],
  ['an arch of 13 wedges', arch(13), 'fine', 1e-3],
];

describe('in a minute', () => {
  for (const [says, all, accuracy, bound] of SCENES)
    fact(`${says} move by less than ${1000 * bound} mm at ${accuracy}`, async () => {
      below(farthest(await standing(all, { accuracy }), 60), bound, 'm');
    });
});
