import { quaternionOf, rotate, scale } from '../../physics-core/base/math.js';
import { move } from '../../references/mechanism.js';
import { turn } from '../../references/turning.js';
import type { Case, Vec3 } from '../case.js';
import { apart, frameOf, rounding, worst } from './judging.js';

// What swings and turns about one fixed point.

const G = 9.81;
const GRAVITY: Vec3 = [0, -G, 0];

/** Angle below the horizontal of what hangs `arm` metres from its pivot, released level. */
const swinging = (moment: number, mass: number, arm: number) =>
  move(
    {
      places: (at) => [at, -arm * Math.sin(at), arm * Math.cos(at)],
      inertias: [moment, mass, mass],
      pulls: [0, -mass * G],
    },
    0,
    0,
  );

const on = (arm: number, angle: number): Vec3 => [arm * Math.cos(angle), -arm * Math.sin(angle), 0];

const rod = { length: 1, radius: 0.02 };
const rodSwings = swinging(rod.radius ** 2 / 4 + rod.length ** 2 / 12, 1, 0.5);
const ballSwings = swinging(0.4 * 0.1 ** 2, 1, 1);

/** A cone of 0.5 rad about the vertical: the string that the ball hangs on is 1 m long. */
const cone = { angle: 0.5, rate: Math.sqrt(G / Math.cos(0.5)) };
const circling = (t: number): Vec3 => {
  const radius = Math.sin(cone.angle);
  const angle = cone.rate * t;
  return [radius * Math.cos(angle), -Math.cos(cone.angle), -radius * Math.sin(angle)];
};

/** A disc on a stick of 0.3 m, leaning by 0.6 rad and turning about it at 30 rad/s; let go, it nods. */
const top = {
  disc: { radius: 0.5, height: 0.1 },
  arm: 0.3,
  lean: quaternionOf([0, 0, 1, -0.6]),
  speed: 30,
};
const topSpin = rotate(top.lean, [0, top.speed, 0]);
const [topAlong, topAcross] = [0.5 ** 2 / 2, (3 * 0.5 ** 2 + 0.1 ** 2) / 12];
const topTurns = turn({
  moments: [topAcross + top.arm ** 2, topAlong, topAcross + top.arm ** 2],
  orientation: top.lean,
  spin: topSpin,
  arm: [0, top.arm, 0],
  weight: GRAVITY,
});

export const cases: Case[] = [
  {
    id: 'pendulum-rod',
    name: 'Rod pendulum',
    says: "A rod of 1 m on a hinge at its end, let go level, against the pendulum's equation.",
    scene: {
      gravity: GRAVITY,
      bodies: [
        {
          name: 'rod',
          shape: { type: 'Cylinder', radius: rod.radius, height: rod.length },
          position: [0.5, 0, 0],
          orientation: [0, 0, 1, -Math.PI / 2],
        },
      ],
      joints: [{ type: 'SingleAxisHingeJoint', body1: 'rod', axis: [0, 0, 1] }],
    },
    seconds: 5,
    unit: 'm',
    size: 1,
    singlePrecision: rounding(0.5, 3, 5),
    watch: ({ position }) =>
      worst((t) => apart(position('rod'), on(0.5, rodSwings(frameOf(t)).at))),
  },
  {
    id: 'pendulum-ball',
    name: 'Ball pendulum',
    says: "A ball of 0.1 m radius on a ball joint 1 m away, let go level, against the pendulum's equation.",
    scene: {
      gravity: GRAVITY,
      bodies: [{ name: 'ball', shape: { type: 'Sphere', radius: 0.1 }, position: [1, 0, 0] }],
      joints: [{ type: 'BallJoint', body1: 'ball', anchorPoint: [0, 0, 0] }],
    },
    seconds: 5,
    unit: 'm',
    size: 2,
    singlePrecision: rounding(1, 4.5, 5),
    watch: ({ position }) =>
      worst((t) => apart(position('ball'), on(1, ballSwings(frameOf(t)).at))),
  },
  {
    id: 'pendulum-conical',
    name: 'Conical pendulum',
    says: 'A ball on a ball joint 1 m away going round at ω² = g / (L cos θ), against its circle.',
    scene: {
      gravity: GRAVITY,
      bodies: [
        {
          name: 'ball',
          shape: { type: 'Sphere', radius: 0.1 },
          position: circling(0),
          linearVelocity: [0, 0, -cone.rate * Math.sin(cone.angle)],
          angularVelocity: [0, cone.rate, 0],
        },
      ],
      joints: [{ type: 'BallJoint', body1: 'ball', anchorPoint: [0, 0, 0] }],
    },
    seconds: 5,
    unit: 'm',
    size: 1,
    singlePrecision: rounding(1, 1.6, 5),
    watch: ({ position }) => worst((t) => apart(position('ball'), circling(t))),
  },
  {
    id: 'spin-top',
    name: 'Spinning top',
    says: "A disc turning at 30 rad/s on a stick of 0.3 m that leans on a ball joint: where it nods and goes round to, against Euler's equations.",
    scene: {
      gravity: GRAVITY,
      bodies: [
        {
          name: 'top',
          shape: { type: 'Cylinder', ...top.disc },
          position: rotate(top.lean, [0, top.arm, 0]),
          orientation: [0, 0, 1, -0.6],
          angularVelocity: topSpin,
        },
      ],
      joints: [{ type: 'BallJoint', body1: 'top', anchorPoint: [0, 0, 0] }],
    },
    seconds: 3,
    unit: 'm',
    size: 0.3,
    singlePrecision: rounding(0.3, 0.5, 3),
    watch: ({ position }) =>
      worst((t) => apart(position('top'), scale(rotate(topTurns(frameOf(t)), [0, 1, 0]), top.arm))),
  },
];
