import { LAG, near, ROUGH, turn } from '../checks.js';
import type { Driver, Fact } from '../fact.js';
import { body, collection, inertia, WEIGHTLESS } from '../scenes.js';

const READING = 'damping is a force of -factor × velocity, so that mass and moment matter';

const speed = async (x: Driver) => (await x.get('ball', 'linearVelocity'))[0] as number;
const spin = async (x: Driver) => (await x.get('ball', 'angularVelocity'))[1] as number;

/** A ball of 2 kg and 0.5 kg·m² that moves at 4 m/s and turns at 3 rad/s. */
const moving = (fields: Record<string, unknown>) => [
  collection({
    ...WEIGHTLESS,
    bodies: [
      body('ball', {
        mass: 2,
        inertia: inertia(0.5),
        linearVelocity: [4, 0, 0],
        angularVelocity: [0, 3, 0],
        ...fields,
      }),
    ],
  }),
];

export const damping: Fact[] = [
  {
    field: 'autoDamp',
    says: 'damping acts only while it is TRUE',
    open: READING,
    scene: moving({ linearDampingFactor: 0.5, angularDampingFactor: 0.2 }),
    run: async (x) => {
      await x.advance(1);
      const free = [await speed(x), await spin(x)];
      await x.set('ball', 'autoDamp', true);
      await x.advance(1);
      const slow = [await speed(x), await spin(x)];
      await x.set('ball', 'autoDamp', false);
      await x.advance(1);
      const k = [4 * Math.exp(-0.25), 3 * Math.exp(-0.4)];
      return [
        near('not damped', free, [4, 3], 1e-3, 'm/s, rad/s'),
        // The damping of one frame.
        near('damped', slow, k, 1.2 * LAG, 'm/s, rad/s'),
        near('not damped again', [await speed(x), await spin(x)], slow, 1.2 * LAG, 'm/s, rad/s'),
      ];
    },
  },
  {
    field: 'linearDampingFactor',
    says: 'a body slows down by v₀ exp(-k t / m)',
    open: READING,
    scene: moving({ autoDamp: true, linearDampingFactor: 0.5 }),
    run: async (x) => {
      await x.advance(1);
      const first = await speed(x);
      await x.set('ball', 'linearDampingFactor', 1);
      await x.advance(1);
      return [
        near('factor 0.5', first, 4 * Math.exp(-0.25), LAG, 'm/s'),
        near('factor 1', await speed(x), 4 * Math.exp(-0.75), 2 * LAG, 'm/s'),
      ];
    },
  },
  {
    field: 'angularDampingFactor',
    says: 'a body turns slower by ω₀ exp(-k t / I)',
    open: READING,
    scene: moving({ autoDamp: true, angularDampingFactor: 0.2 }),
    run: async (x) => {
      await x.advance(1);
      const first = await spin(x);
      await x.set('ball', 'angularDampingFactor', 0.5);
      await x.advance(1);
      return [
        near('factor 0.2', first, 3 * Math.exp(-0.4), 1.2 * LAG, 'rad/s'),
        near('factor 0.5', await spin(x), 3 * Math.exp(-1.4), 3 * LAG, 'rad/s'),
      ];
    },
  },
];

/** A ball that drifts at 0.2 m/s and turns at 0.2 rad/s for ever, if nothing puts it to rest. */
const drifting = (fields: Record<string, unknown>) => [
  collection({
    ...WEIGHTLESS,
    bodies: [
      body('ball', {
        inertia: inertia(0.1),
        linearVelocity: [0.2, 0, 0],
        angularVelocity: [0, 0.2, 0],
        autoDisable: true,
        disableTime: 0.5,
        disableLinearSpeed: 0.3,
        disableAngularSpeed: 0.3,
        ...fields,
      }),
    ],
  }),
];

/** Metres that it drifts in a time. */
async function drift(x: Driver, seconds: number): Promise<number> {
  const [from] = await x.get('ball', 'position');
  await x.advance(seconds);
  return (await x.get('ball', 'position'))[0] - from;
}

/** Engines look for what may rest every now and then: 0.3 s at 0.2 m/s. */
const LATE = 0.06;

export const rest: Fact[] = [
  {
    field: 'autoDisable',
    says: 'FALSE keeps a slow body moving, TRUE puts it to rest',
    scene: drifting({ autoDisable: false }),
    run: async (x) => {
      const never = await drift(x, 2);
      await x.set('ball', 'autoDisable', true);
      await x.advance(1);
      return [
        near('FALSE, way in 2 s', never, 0.4, 0.4 * ROUGH, 'm'),
        near('TRUE, way in the second after', await drift(x, 1), 0, 1e-4, 'm'),
      ];
    },
  },
  {
    field: 'disableTime',
    says: 'a slow body rests after this time',
    scene: drifting({ disableTime: 1.5 }),
    run: async (x) => {
      const long = await drift(x, 3);
      await x.set('ball', 'disableTime', 0.5);
      await x.set('ball', 'linearVelocity', [0.2, 0, 0]);
      const short = await drift(x, 3);
      return [
        near('1.5 s, way', long, 0.3 + LATE / 2, LATE / 2 + 0.2 * LAG, 'm'),
        near('0.5 s, way', short, 0.1 + LATE / 2, LATE / 2 + 0.2 * LAG, 'm'),
      ];
    },
  },
  ...(
    [
      ['disableLinearSpeed', 'linearVelocity'],
      ['disableAngularSpeed', 'angularVelocity'],
    ] as const
  ).map(([field, velocity]): Fact => ({
    field,
    says: `a body rests only where its ${velocity} is below this`,
    scene: drifting({ [field]: 0.1 }),
    run: async (x) => {
      const fast = await drift(x, 2);
      await x.set('ball', field, 0.3);
      await x.advance(1);
      return [
        near('below its speed, way in 2 s', fast, 0.4, 0.4 * ROUGH, 'm'),
        near('above it, way in the second after', await drift(x, 1), 0, 1e-4, 'm'),
      ];
    },
  })),
  ...(
    [
      ['useFiniteRotation', false, true],
      ['finiteRotationAxis', [0, 1, 0], [1, 0, 0]],
    ] as const
  ).map(([field, before, after]): Fact => ({
    field,
    says: 'is about how well a spin is followed and keeps no body from turning about any axis',
    scene: [
      collection({
        ...WEIGHTLESS,
        bodies: ['x', 'y'].map((name, i) =>
          body(name, {
            position: [3 * i, 0, 0],
            inertia: inertia(0.1),
            angularVelocity: name === 'x' ? [5, 0, 0] : [0, 5, 0],
            useFiniteRotation: true,
            [field]: before,
          }),
        ),
      }),
    ],
    run: async (x) => {
      const turned = async () => [
        ...turn(await x.get('x', 'orientation')),
        ...turn(await x.get('y', 'orientation')),
      ];
      await x.advance(0.25);
      const first = await turned();
      for (const name of ['x', 'y']) await x.set(name, field, after);
      await x.advance(0.25);
      return [
        near('before', first, [1.25, 0, 0, 0, 1.25, 0], 1.25 * ROUGH, 'rad'),
        near('after the event', await turned(), [2.5, 0, 0, 0, 2.5, 0], 2.5 * ROUGH, 'rad'),
      ];
    },
  })),
];
