import { anchorOf, ballAt, cradleAngles, type Cradle } from '../../references/cradle.js';
import type { Case, CaseBody } from '../case.js';
import { frameOf } from './judging.js';
import { offPaths, roundingOf, type Path } from './paths.js';

const cradle: Cradle = { count: 5, radius: 0.1, gap: 0.001, arm: 1, gravity: 9.81 };
/** How far the first ball is raised, radians. */
const RAISED = Math.PI / 6;
const SECONDS = 1.5;

/** Steps of the reference in 1/60 s; twice as many change no place by more than 1e-8 m. */
const PER_FRAME = 128;

let angles: number[][] | undefined;
const path =
  (i: number): Path =>
  (time) => {
    angles ??= cradleAngles(cradle, RAISED, SECONDS, PER_FRAME);
    return [...ballAt(cradle, i, angles[frameOf(time)]![i]!), 0];
  };

const ball = (i: number): CaseBody => {
  const angle = i === 0 ? -RAISED : 0;
  return {
    name: `ball ${i + 1}`,
    shape: { type: 'Sphere', radius: cradle.radius },
    position: [...ballAt(cradle, i, angle), 0],
    orientation: [0, 0, 1, angle],
  };
};

const balls = Array.from({ length: cradle.count }, (_, i) => ball(i));

export const cases: Case[] = [
  {
    id: 'cradle',
    name: "Newton's cradle",
    says: `Five balls on rods, ${cradle.gap * 1000} mm apart, bounce 1, the first raised by 30°: the hits go through one after the other. The places of all balls against pendulums that exchange their speeds, in double precision.`,
    scene: {
      gravity: [0, -cradle.gravity, 0],
      bodies: balls,
      joints: balls.map(({ name }, i) => ({
        type: 'BallJoint',
        body1: name,
        anchorPoint: [...anchorOf(cradle, i), 0],
      })),
      contact: { bounce: 1, friction: 0 },
    },
    seconds: SECONDS,
    unit: 'm',
    size: cradle.arm * RAISED,
    singlePrecision: roundingOf(1, SECONDS),
    watch: offPaths(Object.fromEntries(balls.map(({ name }, i) => [name, path(i)]))),
  },
];
