import { slidingRod, type SlidingRod } from '../../references/sliding-rod.js';
import type { Case, CaseBody } from '../case.js';
import { frameOf } from './judging.js';
import { offPaths, roundingOf, type Path } from './paths.js';

// What leans on a wall, and slides.

const rod: SlidingRod = { length: 2, thickness: 0.1, start: 0.3, gravity: 9.81 };

/** Steps of the reference in 1/60 s; twice as many change no place by more than 1e-9 m. */
const PER_FRAME = 64;

const slides = slidingRod(rod, PER_FRAME);
const path: Path = (time) => {
  const { x, y } = slides(frameOf(time));
  return [x, y, 0];
};

const still = (name: string, size: [number, number, number], x: number, y: number): CaseBody => ({
  name,
  fixed: true,
  shape: { type: 'Box', size },
  position: [x, y, 0],
});

const seconds = 0.9;

export const cases: Case[] = [
  {
    id: 'slide-down-wall',
    name: 'Board slides down a wall',
    says: 'A board of 2 m against a smooth wall, its foot on a smooth floor, let go; its place against the equation of motion, in double precision, up to 2/3 of the height with the wall and then without.',
    scene: {
      gravity: [0, -rod.gravity, 0],
      bodies: [
        still('floor', [20, 1, 4], 9, -0.5),
        still('wall', [1, 4, 4], -0.5, 2),
        {
          name: 'board',
          shape: { type: 'Box', size: [rod.thickness, rod.length, 0.6] },
          position: path(0),
          orientation: [0, 0, 1, rod.start],
        },
      ],
      contact: { bounce: 0, friction: 0 },
    },
    seconds,
    unit: 'm',
    size: 1,
    singlePrecision: roundingOf(1, seconds),
    watch: offPaths({ board: path }),
  },
];
