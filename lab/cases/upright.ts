import { pendulumAngle } from '../../references/elliptic.js';
import type { Case, Vec3 } from '../case.js';
import { drivenCase } from './driven.js';
import { rounding } from './judging.js';
import { offPaths, type Path } from './paths.js';

// Pendulums that come near to where they would stand on their head.

const G = 9.81;
const GRAVITY: Vec3 = [0, -G, 0];

// ---- a large swing ---------------------------------------------------------------------------------------------------

const board: Vec3 = [0.1, 1, 0.05];
const [width, height] = board;
/** About its end, per mass, m². */
const boardMoment = (width ** 2 + height ** 2) / 12 + height ** 2 / 4;
const START = (150 / 180) * Math.PI;
const angleAt = pendulumAngle(START, Math.sqrt((G * height) / 2 / boardMoment));
const boardPath: Path = (time) => {
  const angle = angleAt(time);
  return [(height / 2) * Math.sin(angle), (-height / 2) * Math.cos(angle), 0];
};

const largeSwing: Case = {
  id: 'pendulum-large',
  name: 'Pendulum let go at 150°',
  says: "A board of 1 m on a hinge at its end, let go 30° beside its head; its place against Jacobi's elliptic functions, by which a swing takes 1.8 times as long as a little one.",
  scene: {
    gravity: GRAVITY,
    bodies: [
      {
        name: 'board',
        shape: { type: 'Box', size: board },
        position: boardPath(0),
        orientation: [0, 0, 1, START],
      },
    ],
    joints: [{ type: 'SingleAxisHingeJoint', body1: 'board', axis: [0, 0, 1] }],
  },
  seconds: 5,
  unit: 'm',
  size: 1,
  // A share that rounding adds to the speed moves the turning point by 7.5 times as much, rad, and each such radian
  // the period by 1.95 s: five times what that speed alone would make of the way.
  singlePrecision: 5 * rounding(0.5, 3.4, 5),
  watch: offPaths({ board: boardPath }),
};

// ---- Kapitza's -------------------------------------------------------------------------------------------------------

/** Six times a second: what is moved at more than √(2 g L) holds its pendulum up, and this is 3.8 m/s against 2.8 m/s. */
const kapitza = drivenCase({
  id: 'pendulum-kapitza',
  name: "Kapitza's pendulum",
  says: 'A ball on a ball joint 0.4 m above a pivot that is moved up and down by 0.2 m six times a second, which holds it up; its place against the equation of motion, in double precision.',
  driven: {
    arm: 0.4,
    way: 0.1,
    gravity: G,
    along: 'y',
    rate: 12 * Math.PI,
    start: Math.PI - 0.3,
  },
  seconds: 4,
  size: 0.4,
});

export const cases: Case[] = [largeSwing, kapitza];
