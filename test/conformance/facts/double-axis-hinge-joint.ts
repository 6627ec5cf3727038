import { FRAME, LAG, near, ROUGH, turn } from '../checks.js';
import type { Driver, Fact } from '../fact.js';
import { body, collection, inertia, joint, WEIGHTLESS } from '../scenes.js';
import { ball, jointFacts, output, pin } from './joint-facts.js';
import { axisFact, axisOutputs, place } from './two-axis-facts.js';

const TYPE = 'DoubleAxisHingeJoint';
const SIGN = 'the sign: body1 relative to body2, as in the engine the component was made after';
const H = 1 / 60;

type Fields = Record<string, unknown>;
type Bodies = { body1: string; body2: string };

/** A wheel of 1 kg·m² about Y (axis 1) and X (axis 2) against the pin. As body1 its turns are the angles. */
const wheel = (
  hinge: Fields,
  fields: Fields = {},
  bodies: Bodies = { body1: 'wheel', body2: 'pin' },
) => [
  collection({
    ...WEIGHTLESS,
    bodies: [pin(), ball('wheel', { inertia: inertia(1), ...fields })],
    joints: [
      joint(TYPE, bodies, { axis1: [0, 1, 0], axis2: [1, 0, 0], forceOutput: ['ALL'], ...hinge }),
    ],
  }),
];

const spin = (x: Driver) => x.get('wheel', 'angularVelocity');
const turned = async (x: Driver): Promise<number> => turn(await x.get('wheel', 'orientation'))[1]!;

const stops: Fact[] = [
  ...(['minAngle1', 'maxAngle1'] as const).flatMap((field): Fact[] => {
    const sign = field === 'minAngle1' ? -1 : 1;
    return [
      {
        field,
        says: 'is a stop about axis 1: the wheel turns to it and no further, and further once it is moved',
        scene: wheel({ minAngle1: -0.5, maxAngle1: 0.5 }, { angularVelocity: [0, 2 * sign, 0] }),
        run: async (x) => {
          await x.advance(1);
          const first = await turned(x);
          await x.set('joint', field, 0.9 * sign);
          await x.set('wheel', 'angularVelocity', [0, 2 * sign, 0]);
          await x.advance(1);
          return [
            near('at 0.5', first, 0.5 * sign, 0.02, 'rad'),
            near('at 0.9', await turned(x), 0.9 * sign, 0.02, 'rad'),
          ];
        },
      },
      {
        field,
        says: 'stops nothing about axis 2',
        scene: wheel({ minAngle1: -0.1, maxAngle1: 0.1 }, { angularVelocity: [2 * sign, 0, 0] }),
        run: async (x) => {
          await x.advance(1);
          return [near('spin', await spin(x), [2 * sign, 0, 0], 2 * ROUGH, 'rad/s')];
        },
      },
    ];
  }),
  {
    field: 'stop1Bounce',
    says: 'is the share of its rate with which the wheel comes back from a stop',
    scene: wheel(
      { maxAngle1: 0.5, stop1Bounce: 0.8, stop1ConstantForceMix: 0 },
      { angularVelocity: [0, 2, 0] },
    ),
    run: async (x) => {
      await x.advance(0.5);
      const first = (await spin(x))[1];
      await x.set('joint', 'stop1Bounce', 0.3);
      await x.set('wheel', 'orientation', [0, 0, 1, 0]);
      await x.set('wheel', 'angularVelocity', [0, 2, 0]);
      await x.advance(0.5);
      return [
        near('at 0.8', first, -1.6, 0.05, 'rad/s'),
        near('at 0.3', (await spin(x))[1], -0.6, 0.05, 'rad/s'),
      ];
    },
  },
  {
    field: 'stop1ErrorCorrection',
    says: 'is the share of an overshoot that a frame repairs',
    open: 'per frame of 1/60 s, whatever the step of the browser',
    scene: wheel({ maxAngle1: 0.5, stop1ErrorCorrection: 0.3, stop1ConstantForceMix: 0 }),
    run: async (x) => {
      const left = async () => {
        await x.set('wheel', 'orientation', [0, 1, 0, 0.7]);
        await x.set('wheel', 'angularVelocity', [0, 0, 0]);
        await x.advance(FRAME);
        return (await turned(x)) - 0.5;
      };
      await x.advance(FRAME);
      const first = await left();
      await x.set('joint', 'stop1ErrorCorrection', 0.6);
      return [
        near('left of 0.2 rad at 0.3', first, 0.14, 0.005, 'rad'),
        near('left of 0.2 rad at 0.6', await left(), 0.08, 0.005, 'rad'),
      ];
    },
  },
  {
    field: 'stop1ConstantForceMix',
    says: 'lets the stop give way: under a steady torque by τ · h · constantForceMix / errorCorrection',
    scene: wheel({ maxAngle1: 0.5, stop1ConstantForceMix: 0.1 }, { torques: [[0, 5, 0]] }),
    run: async (x) => {
      await x.advance(4);
      const first = (await turned(x)) - 0.5;
      await x.set('joint', 'stop1ConstantForceMix', 0.4);
      // It swings: what is left of it halves in 2.8 s.
      await x.advance(24);
      return [
        near('at 0.1', first, (5 * H * 0.1) / 0.8, 2e-4, 'rad'),
        near('at 0.4', (await turned(x)) - 0.5, (5 * H * 0.4) / 0.8, 2e-4, 'rad'),
      ];
    },
  },
];

/** The motor of axis `n` turns the wheel about Y or X. */
const motors: Fact[] = ([1, 2] as const).flatMap((n): Fact[] => {
  const about = n === 1 ? 1 : 0;
  const [speed, strength] = [`desiredAngularVelocity${n}`, `maxTorque${n}`];
  return [
    {
      field: speed,
      says: `is the rate that the motor about axis ${n} reaches after I ω / τ, and keeps`,
      open: SIGN,
      scene: wheel({ [speed]: 2, [strength]: 4 }),
      run: async (x) => {
        await x.advance(0.25);
        const half = (await spin(x))[about];
        await x.advance(0.5);
        const whole = await spin(x);
        await x.set('joint', speed, -1);
        await x.advance(1.5);
        return [
          near('half way', half, 1, 4 * LAG, 'rad/s'),
          near('there', whole, n === 1 ? [0, 2, 0] : [2, 0, 0], 0.01, 'rad/s'),
          near('the other way', (await spin(x))[about], -1, 0.01, 'rad/s'),
        ];
      },
    },
    {
      field: strength,
      says: 'is the torque with which it gets there; at 0 there is no motor, and the wheel turns on',
      scene: wheel({ [speed]: 100, [strength]: 2 }),
      run: async (x) => {
        await x.advance(0.5);
        const first = (await spin(x))[about];
        await x.set('joint', strength, 6);
        await x.advance(0.5);
        const second = (await spin(x))[about];
        await x.set('joint', strength, 0);
        await x.advance(0.5);
        return [
          near('at 2 N·m', first, 1, 2 * LAG, 'rad/s'),
          near('at 6 N·m', second, 4, 8 * LAG, 'rad/s'),
          near('at none', (await spin(x))[about], second, 6 * LAG, 'rad/s'),
        ];
      },
    },
  ];
});

/** Under a weight of 10 N the spring of k = errorCorrection / (h · force) sinks in by 10 / k and comes to rest. */
const SUSPENDED = { axis1: [0, 1, 0], axis2: [1, 0, 0] };
const hung = (hinge: Fields) => [
  collection({
    gravity: [0, -10, 0],
    bodies: [pin(), ball('wheel')],
    joints: [joint(TYPE, { body1: 'pin', body2: 'wheel' }, { ...SUSPENDED, ...hinge })],
  }),
];
const height = async (x: Driver): Promise<number> => (await x.get('wheel', 'position'))[1];
const sag = (force: number, share: number): number => (-10 * H * force) / share;

const suspension: Fact[] = [
  {
    field: 'suspensionForce',
    says: 'is the softness of a spring along axis 1: a weight sinks in by m g h · suspensionForce / suspensionErrorCorrection',
    open: 'h is 1/60 s, so that a suspension is the same at every step',
    scene: hung({ suspensionForce: 0.1, suspensionErrorCorrection: 0.5 }),
    run: async (x) => {
      await x.advance(6);
      const soft = await height(x);
      await x.set('joint', 'suspensionForce', 0.3);
      await x.advance(12);
      const softer = await height(x);
      await x.set('joint', 'suspensionForce', 0);
      await x.advance(3);
      return [
        near('at 0.1', soft, sag(0.1, 0.5), 1e-3, 'm'),
        near('at 0.3', softer, sag(0.3, 0.5), 1e-3, 'm'),
        near('rigid at 0', await height(x), 0, 1e-3, 'm'),
      ];
    },
  },
  {
    field: 'suspensionErrorCorrection',
    says: 'is what of it is spring: stiffness errorCorrection / (h · force), damping (1 - errorCorrection) / force',
    open: 'h is 1/60 s, so that a suspension is the same at every step',
    scene: hung({ suspensionForce: 0.2, suspensionErrorCorrection: 0.9 }),
    run: async (x) => {
      await x.advance(0.25);
      const swinging = await height(x);
      await x.advance(20);
      const first = await height(x);
      await x.set('joint', 'suspensionErrorCorrection', 0.3);
      await x.advance(6);
      // 1 kg on 270 N/m and 0.5 N s/m.
      const [k, c] = [0.9 / (H * 0.2), 0.1 / 0.2];
      const w = Math.sqrt(k - (c * c) / 4);
      const decay = Math.exp((-c / 2) * 0.25);
      const expected =
        sag(0.2, 0.9) * (1 - decay * (Math.cos(w * 0.25) + (c / 2 / w) * Math.sin(w * 0.25)));
      return [
        // 0.6 m/s at most.
        near('swinging', swinging, expected, 0.6 * LAG, 'm'),
        near('at 0.9', first, sag(0.2, 0.9), 1e-3, 'm'),
        near('at 0.3', await height(x), sag(0.2, 0.3), 1e-3, 'm'),
      ];
    },
  },
];

const OUTPUTS = { 1: [0, 1, 0], 2: [1, 0, 0] };

const outputs: Fact[] = ([1, 2] as const).flatMap((n): Fact[] => {
  const about = (rate: number) => OUTPUTS[n].map((value) => value * rate);
  const scene = [
    collection({
      ...WEIGHTLESS,
      bodies: [
        body('first', { geometry: [], inertia: inertia(1), angularVelocity: about(2) }),
        body('second', { geometry: [], inertia: inertia(1), angularVelocity: about(-1) }),
      ],
      joints: [
        joint(TYPE, { body1: 'first', body2: 'second' }, { ...SUSPENDED, forceOutput: ['ALL'] }),
      ],
    }),
  ];
  return [
    {
      field: `hinge${n}Angle`,
      says: `is how far body1 has turned about axis ${n} against body2 since the joint was made`,
      open: SIGN,
      scene,
      run: async (x) => {
        await x.advance(0.5);
        return [
          near('this one', await output(x, `hinge${n}Angle`), 1.5, 3 * LAG, 'rad'),
          near('the other', await output(x, `hinge${3 - n}Angle`), 0, 0.01, 'rad'),
        ];
      },
    },
    {
      field: `hinge${n}AngleRate`,
      says: `is how fast body1 turns about axis ${n} against body2`,
      open: SIGN,
      scene,
      run: async (x) => {
        await x.advance(0.5);
        return [
          near('this one', await output(x, `hinge${n}AngleRate`), 3, 0.02, 'rad/s'),
          near('the other', await output(x, `hinge${3 - n}AngleRate`), 0, 0.02, 'rad/s'),
        ];
      },
    },
  ];
});

export const doubleAxisHingeJoint: Fact[] = [
  ...jointFacts(TYPE, { axis1: [0, 1, 0], axis2: [0, 0, 1] }),
  place(TYPE),
  axisFact(TYPE, 'axis1', [0, 0, 1], [0, 0.1, 0.1]),
  axisFact(TYPE, 'axis2', [0, 0, 1], [0.1, 0, 0.1]),
  ...axisOutputs(TYPE),
  ...stops,
  ...motors,
  ...suspension,
  ...outputs,
];
