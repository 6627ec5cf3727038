import { add, multiply, quaternionOf, rotate, scale } from '../../physics-core/base/math.js';
import { turn } from '../../references/turning.js';
import type { Case, Quaternion, Vec3 } from '../case.js';
import { apart, frameOf, rounding, turned, worst } from './judging.js';

// What touches nothing and hangs on nothing.

const WEIGHTLESS: Vec3 = [0, 0, 0];
const GRAVITY: Vec3 = [0, -9.81, 0];

const launch: Vec3 = [3, 8, 1];
const thrown = (t: number, acceleration: Vec3): Vec3 =>
  add(scale(launch, t), scale(acceleration, t ** 2 / 2));

/** Newton seconds of drag per metre, for 2 kg. */
const DRAG = 0.8;

/** Where drag -k v and gravity take what is launched. */
function dragged(t: number): Vec3 {
  const k = DRAG / 2;
  const lost = (1 - Math.exp(-k * t)) / k;
  return add(scale(launch, lost), scale(GRAVITY, (t - lost) / k));
}

const ballSpin: Vec3 = [3, 4, 12];

const cylinder = { radius: 0.5, height: 2 };
const cylinderSpin: Vec3 = [1, 5, 0];
/** Of 1 kg: about its axis y and across it. */
const [alongY, across] = [0.5 ** 2 / 2, (3 * 0.5 ** 2 + 2 ** 2) / 12];

/** About its own axis at what the moments differ by, and about the angular momentum, which stands still. */
function nutated(t: number): Quaternion {
  const [x, y, z] = cylinderSpin;
  const momentum: Vec3 = [across * x, alongY * y, across * z];
  const rate = Math.hypot(...momentum) / across;
  const own = quaternionOf([0, 1, 0, y * (1 - alongY / across) * t]);
  return multiply(quaternionOf([...momentum, rate * t]), own);
}

const racket = { moments: [1, 2, 3] as Vec3, spin: [0.05, 3, 0.02] as Vec3 };
const flips = turn(racket);

const rod = { length: 2, radius: 0.05, mass: 3 };
/** Struck with 6 N s along z, 0.4 m from its middle. */
const blow = { impulse: 6, at: 0.4 };
const rodMoment = rod.mass * (rod.radius ** 2 / 4 + rod.length ** 2 / 12);
const struck = {
  speed: blow.impulse / rod.mass,
  spin: (blow.impulse * blow.at) / rodMoment,
};
/** On the far side, the point that the blow leaves at rest at first. */
const centreOfPercussion = -struck.speed / struck.spin;

const pushed = { force: [4, 0, -2] as Vec3, torque: 1.5 };

export const cases: Case[] = [
  {
    id: 'flight-projectile',
    name: 'Projectile',
    says: 'A ball thrown at 8.6 m/s, against x = v t + ½ g t².',
    scene: {
      gravity: GRAVITY,
      bodies: [{ name: 'ball', shape: { type: 'Sphere', radius: 0.1 }, linearVelocity: launch }],
    },
    seconds: 2,
    unit: 'm',
    size: 10,
    singlePrecision: rounding(8, 12, 2),
    watch: ({ position }) => worst((t) => apart(position('ball'), thrown(t, GRAVITY))),
  },
  {
    id: 'flight-thrust',
    name: 'Thrust',
    says: 'A ball of 2 kg under a steady force and torque, against ½ a t² and ½ α t².',
    scene: {
      gravity: GRAVITY,
      bodies: [
        {
          name: 'ball',
          mass: 2,
          inertia: [0.5, 0.5, 0.5],
          linearVelocity: launch,
          forces: [pushed.force],
          torques: [[0, 0, pushed.torque]],
        },
      ],
    },
    seconds: 2,
    unit: 'm',
    size: 10,
    // The end of an arm of 1 m is looked at, so that turning counts as well.
    singlePrecision: rounding(9, 12, 2) + rounding(1, 6, 2),
    watch: ({ position, orientation }) =>
      worst((t) => {
        const path = thrown(t, add(GRAVITY, scale(pushed.force, 1 / 2)));
        const turn = quaternionOf([0, 0, 1, (pushed.torque / 0.5 / 2) * t ** 2]);
        const end = rotate(orientation('ball'), [1, 0, 0]);
        return apart(add(position('ball'), end), add(path, rotate(turn, [1, 0, 0])));
      }),
  },
  {
    id: 'flight-drag',
    name: 'Projectile with drag',
    says: 'A ball of 2 kg thrown at 8.6 m/s under a drag of 0.8 N s/m, against v = g/k + (v₀ - g/k) e^(-k t).',
    scene: {
      gravity: GRAVITY,
      bodies: [
        {
          name: 'ball',
          mass: 2,
          shape: { type: 'Sphere', radius: 0.1 },
          linearVelocity: launch,
          autoDamp: true,
          linearDampingFactor: DRAG,
          angularDampingFactor: 0,
        },
      ],
    },
    seconds: 3,
    unit: 'm',
    size: 10,
    singlePrecision: rounding(16, 13, 3),
    watch: ({ position }) => worst((t) => apart(position('ball'), dragged(t))),
  },
  {
    id: 'spin-ball',
    name: 'Spinning ball',
    says: 'A ball turning at 13 rad/s, against the angle ω t.',
    scene: {
      gravity: WEIGHTLESS,
      bodies: [{ name: 'ball', shape: { type: 'Sphere', radius: 0.5 }, angularVelocity: ballSpin }],
    },
    seconds: 5,
    unit: 'rad',
    size: 65,
    singlePrecision: rounding(1, 13, 5),
    watch: ({ orientation }) =>
      worst((t) => turned(orientation('ball'), quaternionOf([...ballSpin, 13 * t]))),
  },
  {
    id: 'spin-cylinder',
    name: 'Wobbling cylinder',
    says: "A free cylinder turning at 5.1 rad/s, not quite about its axis, against its two precessions: L / I₁ and the body's own.",
    scene: {
      gravity: WEIGHTLESS,
      bodies: [
        {
          name: 'cylinder',
          shape: { type: 'Cylinder', ...cylinder },
          angularVelocity: cylinderSpin,
        },
      ],
    },
    seconds: 5,
    unit: 'rad',
    size: 25,
    singlePrecision: rounding(1, 5.1, 5),
    watch: ({ orientation }) => worst((t) => turned(orientation('cylinder'), nutated(t))),
  },
  {
    id: 'spin-racket',
    name: 'Flipping racket',
    says: "A free body of moments 1, 2, 3 turning about the middle one at 3 rad/s, which flips over after 3.8 s, against Euler's equations.",
    scene: {
      gravity: WEIGHTLESS,
      bodies: [{ name: 'racket', inertia: racket.moments, angularVelocity: racket.spin }],
    },
    seconds: 5,
    unit: 'rad',
    size: 15,
    // What is off by 2^-24 of 3 rad/s at first is off by e^(1.73 · 3.8) times that at the flip.
    singlePrecision: 3 * 2 ** -24 * Math.exp((3 / Math.sqrt(3)) * 3.8),
    watch: ({ orientation }) => worst((t) => turned(orientation('racket'), flips(frameOf(t)))),
  },
  {
    id: 'flight-struck-rod',
    name: 'Struck rod',
    says: 'A rod struck off its centre flies at J / m and turns at J r / I: its end and its centre of percussion, against both.',
    scene: {
      gravity: GRAVITY,
      bodies: [
        {
          name: 'rod',
          mass: rod.mass,
          shape: { type: 'Cylinder', radius: rod.radius, height: rod.length },
          linearVelocity: [0, 0, struck.speed],
          angularVelocity: [struck.spin, 0, 0],
        },
      ],
    },
    seconds: 2,
    unit: 'm',
    size: 10,
    singlePrecision: rounding(20, 20, 2) + rounding(1, struck.spin, 2),
    watch: ({ position, orientation }) =>
      worst((t) => {
        const centre = add(scale([0, 0, struck.speed], t), scale(GRAVITY, t ** 2 / 2));
        const turn = quaternionOf([1, 0, 0, struck.spin * t]);
        return Math.max(
          ...[rod.length / 2, centreOfPercussion].map((at) =>
            apart(
              add(position('rod'), rotate(orientation('rod'), [0, at, 0])),
              add(centre, rotate(turn, [0, at, 0])),
            ),
          ),
        );
      }),
  },
];
