import { cross, scale, subtract } from '../../physics-core/base/math.js';
import type { Case, Vec3 } from '../case.js';
import { offPathsOnFloor, roundingOf, type Path } from './paths.js';

// What rolls on what turns: the centre of a ball goes round at 2/7 of the table's turn, wherever the table's axis is.

const UP: Vec3 = [0, 1, 0];
const RADIUS = 0.25;
/** rad/s of the table, and of the ball's way. */
const TURN = 3;
const ROUND = (2 / 7) * TURN;
const SPEED = 1;
/** Of the ball's circle, which is not about the axis. */
const middle: Vec3 = [0.5, 0, 0];
const WIDE = SPEED / ROUND;

const path: Path = (time) => [
  middle[0] + WIDE * Math.cos(ROUND * time),
  RADIUS,
  middle[2] - WIDE * Math.sin(ROUND * time),
];
const velocity: Vec3 = [0, 0, -SPEED];
/** Of the ball's lowest point against its centre, as the table goes there. */
const below = subtract(cross([0, TURN, 0], path(0)), velocity);
const spin = scale(cross(UP, below), -1 / RADIUS);
const seconds = 7;

export const cases: Case[] = [
  {
    id: 'turntable-ball',
    name: 'Ball on a turntable',
    says: `A ball rolls at ${SPEED} m/s on a disc that is turned at ${TURN} rad/s, friction 0.5; its place against the circle on which it goes round at 2/7 of the disc's turn.`,
    scene: {
      gravity: [0, -9.81, 0],
      bodies: [
        {
          name: 'table',
          fixed: true,
          shape: { type: 'Cylinder', radius: 3, height: 1 },
          position: [0, -0.5, 0],
          turn: (time) => [...UP, TURN * time],
        },
        {
          name: 'ball',
          shape: { type: 'Sphere', radius: RADIUS },
          position: path(0),
          linearVelocity: velocity,
          angularVelocity: spin,
        },
      ],
      contact: { bounce: 0, friction: 0.5 },
    },
    seconds,
    unit: 'm',
    size: 2 * WIDE,
    singlePrecision: roundingOf(2, seconds),
    watch: offPathsOnFloor({ ball: path }),
  },
];
