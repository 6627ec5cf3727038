import type { Case, CaseJoint, Vec3 } from '../case.js';
import { apart, rounding, worst } from './judging.js';

// The suspension of a DoubleAxisHingeJoint, which is a spring and a damper along its first axis.

/** N/m and N s/m of X3D's two fields. */
const stiffnessOf = (force: number, share: number): number => (60 * share) / force;
const dampingOf = (force: number, share: number): number => (1 - share) / force;

const strut = (force: number, share: number): CaseJoint => ({
  type: 'DoubleAxisHingeJoint',
  body1: 'wheel',
  axis1: [0, 1, 0],
  axis2: [1, 0, 0],
  suspensionForce: force,
  suspensionErrorCorrection: share,
});

const car = { mass: 20, force: 0.02, share: 0.6, gravity: 9.81 };
const decay = dampingOf(car.force, car.share) / 2 / car.mass;
const natural2 = stiffnessOf(car.force, car.share) / car.mass;
const sag = car.gravity / natural2;

/** Metres that the wheel has sunk into its spring. */
function sunk(t: number): number {
  const omega = Math.sqrt(natural2 - decay ** 2);
  const swing = Math.cos(omega * t) + (decay / omega) * Math.sin(omega * t);
  return sag * (1 - Math.exp(-decay * t) * swing);
}

const pair = { masses: [1, 3] as const, force: 0.6, speed: 2 };
const reduced = (pair.masses[0] * pair.masses[1]) / (pair.masses[0] + pair.masses[1]);
const swings = Math.sqrt(stiffnessOf(pair.force, 1) / reduced);

export const cases: Case[] = [
  {
    id: 'spring-suspension',
    name: 'Suspension',
    says: "A wheel of 20 kg let down on its suspension, against x'' + 2 ζ ω x' + ω² x = g, down to the sag m g / k.",
    scene: {
      gravity: [0, -car.gravity, 0],
      bodies: [{ name: 'wheel', mass: car.mass, inertia: [1, 1, 1] }],
      joints: [strut(car.force, car.share)],
    },
    seconds: 3,
    unit: 'm',
    size: sag,
    singlePrecision: rounding(2 * sag, 1, 3),
    watch: ({ position }) => worst((t) => apart(position('wheel'), [0, -sunk(t), 0])),
  },
  {
    id: 'spring-between',
    name: 'Spring between two bodies',
    says: 'Two free bodies on an undamped spring: how far they are apart, against ω = √(k / μ).',
    scene: {
      gravity: [0, 0, 0],
      bodies: [
        { name: 'wheel', mass: 1, inertia: [1, 1, 1], linearVelocity: [0, 1.5, 0] as Vec3 },
        {
          name: 'car',
          mass: 3,
          inertia: [1, 1, 1],
          position: [0, 1, 0] as Vec3,
          linearVelocity: [0, -0.5, 0] as Vec3,
        },
      ],
      joints: [{ ...strut(pair.force, 1), body2: 'car' }],
    },
    seconds: 3,
    unit: 'm',
    size: pair.speed / swings,
    singlePrecision: rounding(1, pair.speed, 3),
    watch: ({ position }) =>
      worst((t) => {
        const stretch = (pair.speed / swings) * Math.sin(swings * t);
        return Math.abs(position('wheel')[1] - position('car')[1] + 1 - stretch);
      }),
  },
];
