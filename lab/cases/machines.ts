import { quaternionOf } from '../../physics-core/base/math.js';
import { move } from '../../references/mechanism.js';
import type { Case, Vec3 } from '../case.js';
import { apart, frameOf, round, rounding, turned, worst } from './judging.js';

// Joints that drive, stop and pass on.

const WEIGHTLESS: Vec3 = [0, 0, 0];
const G = 9.81;

// ---- motors ----------------------------------------------------------------------------------------------------------

const motor = { torque: 4, speed: 8, moment: 0.5 };

/** Radians after it ran up to speed and on. */
function runUp(t: number): number {
  const { torque, speed, moment } = motor;
  const until = (moment * speed) / torque;
  return t < until ? ((torque / moment) * t ** 2) / 2 : speed * (t - until / 2);
}

// ---- a stop ------------------------------------------------------------------------------------------------------------

const stop = { force: 6, mass: 2, at: 1, bounce: 0.7 };

/** Metres along the slider under a steady force against the stop. */
function thrownBack(t: number): number {
  const a = stop.force / stop.mass;
  let arrival = Math.sqrt((2 * stop.at) / a);
  if (t < arrival) return (a * t ** 2) / 2;
  let speed = stop.bounce * a * arrival;
  while (t > arrival + (2 * speed) / a) {
    arrival += (2 * speed) / a;
    speed *= stop.bounce;
  }
  const since = t - arrival;
  return stop.at - speed * since + (a * since ** 2) / 2;
}

// ---- a cardan shaft ----------------------------------------------------------------------------------------------------

const cardan = { bend: 0.6, driving: 2, driven: 0.5, speed: 3 };
const shaft: Vec3 = [0, -Math.sin(cardan.bend), Math.cos(cardan.bend)];
const arm: Vec3 = [0, Math.cos(cardan.bend), Math.sin(cardan.bend)];

/** tan θ₂ = cos β tan θ₁, without the jumps of a tangent. */
function passedOn(angle: number): number {
  const [sine, cosine, bend] = [Math.sin(angle), Math.cos(angle), Math.cos(cardan.bend)];
  return angle + Math.atan2((bend - 1) * sine * cosine, cosine * cosine + bend * sine * sine);
}
const cardanTurns = move(
  { places: (at) => [at, passedOn(at)], inertias: [cardan.driving, cardan.driven] },
  0,
  cardan.speed,
);

// ---- a balance -------------------------------------------------------------------------------------------------------------

const balance = { half: 1, beam: 1 / 3, left: 3, right: 2 };
const balanceTips = move(
  {
    places: (at) => [at, balance.half * Math.sin(at), balance.half * Math.cos(at)],
    inertias: [balance.beam, balance.left + balance.right, balance.left + balance.right],
    pulls: [0, -(balance.right - balance.left) * G],
  },
  0,
  0,
);

export const cases: Case[] = [
  {
    id: 'motor-run-up',
    name: 'Motor',
    says: 'A wheel that a motor of 4 N m runs up to 8 rad/s and holds there: the angle turned, against ½ α t² and then ω t.',
    scene: {
      gravity: WEIGHTLESS,
      bodies: [{ name: 'wheel', inertia: round(motor.moment) }],
      joints: [
        {
          type: 'DoubleAxisHingeJoint',
          body1: 'wheel',
          axis1: [0, 1, 0],
          axis2: [1, 0, 0],
          minAngle1: 0,
          maxAngle1: 0,
          desiredAngularVelocity2: motor.speed,
          maxTorque2: motor.torque,
        },
      ],
    },
    seconds: 2,
    unit: 'rad',
    size: 12,
    singlePrecision: rounding(1, motor.speed, 2),
    watch: ({ orientation }) =>
      worst((t) => turned(orientation('wheel'), quaternionOf([1, 0, 0, runUp(t)]))),
  },
  {
    id: 'motor-torque',
    name: 'Torque motor',
    says: 'A wheel on a hinge that a steady torque turns: the angle turned, against ½ α t².',
    scene: {
      gravity: WEIGHTLESS,
      bodies: [{ name: 'wheel', inertia: round(motor.moment) }],
      joints: [
        { type: 'SingleAxisHingeJoint', body1: 'wheel', axis: [0, 0, 1] },
        {
          type: 'MotorJoint',
          body1: 'wheel',
          motor1Axis: [0, 0, 1],
          enabledAxes: 1,
          axis1Torque: motor.torque,
        },
      ],
    },
    seconds: 2,
    unit: 'rad',
    size: 16,
    singlePrecision: rounding(1, 16, 2),
    watch: ({ orientation }) =>
      worst((t) =>
        turned(
          orientation('wheel'),
          quaternionOf([0, 0, 1, ((motor.torque / motor.moment) * t ** 2) / 2]),
        ),
      ),
  },
  {
    id: 'slider-stop',
    name: 'Slider at its stop',
    says: 'A body on a slider that a steady force drives against a stop, which throws 0.7 of its speed back, against the parabolas between the bounces.',
    scene: {
      gravity: WEIGHTLESS,
      bodies: [
        { name: 'carriage', mass: stop.mass, inertia: round(1), forces: [[stop.force, 0, 0]] },
      ],
      joints: [
        {
          type: 'SliderJoint',
          body1: 'carriage',
          axis: [1, 0, 0],
          minSeparation: -10,
          maxSeparation: stop.at,
          stopBounce: stop.bounce,
        },
      ],
    },
    seconds: 3,
    unit: 'm',
    size: 1,
    singlePrecision: rounding(1, 2.5, 3),
    watch: ({ position }) => worst((t) => apart(position('carriage'), [thrownBack(t), 0, 0])),
  },
  {
    id: 'cardan-shaft',
    name: 'Cardan shaft',
    says: 'A flywheel turns another round a bend of 0.6 rad: the angle of the second, against tan θ₂ = cos β tan θ₁ and the energy that both share.',
    scene: {
      gravity: WEIGHTLESS,
      bodies: [
        {
          name: 'driving',
          inertia: round(cardan.driving),
          angularVelocity: [0, 0, cardan.speed],
        },
        {
          name: 'driven',
          inertia: round(cardan.driven),
          position: shaft,
          angularVelocity: shaft.map((x) => x * cardan.speed * Math.cos(cardan.bend)) as Vec3,
        },
      ],
      joints: [
        { type: 'SingleAxisHingeJoint', body1: 'driving', axis: [0, 0, 1] },
        { type: 'SingleAxisHingeJoint', body1: 'driven', axis: shaft, anchorPoint: shaft },
        { type: 'UniversalJoint', body1: 'driving', body2: 'driven', axis1: [1, 0, 0], axis2: arm },
      ],
    },
    seconds: 4,
    unit: 'rad',
    size: 12,
    singlePrecision: rounding(1, cardan.speed, 4),
    watch: ({ orientation }) =>
      worst((t) => {
        const angle = passedOn(cardanTurns(frameOf(t)).at);
        return turned(orientation('driven'), quaternionOf([...shaft, angle]));
      }),
  },
  {
    id: 'balance',
    name: 'Balance',
    says: 'A beam of 2 m on a hinge with 3 kg on one end and 2 kg on the other, let go level, against (I + Σ m L²) α = Σ ± m g L cos θ.',
    scene: {
      gravity: [0, -G, 0],
      bodies: [
        { name: 'beam', inertia: round(balance.beam) },
        ...(['left', 'right'] as const).map((side) => ({
          name: side,
          mass: balance[side],
          shape: { type: 'Sphere' as const, radius: 0.1 },
          position: [side === 'left' ? -1 : 1, 0, 0] as Vec3,
        })),
      ],
      joints: [
        { type: 'SingleAxisHingeJoint', body1: 'beam', axis: [0, 0, 1] },
        { type: 'BallJoint', body1: 'left', body2: 'beam', anchorPoint: [-1, 0, 0] },
        { type: 'BallJoint', body1: 'right', body2: 'beam', anchorPoint: [1, 0, 0] },
      ],
    },
    seconds: 2,
    unit: 'm',
    size: 1,
    singlePrecision: rounding(1, 2.5, 2),
    watch: ({ position }) =>
      worst((t) => {
        const { at } = balanceTips(frameOf(t));
        return apart(position('right'), [Math.cos(at), Math.sin(at), 0]);
      }),
  },
];
