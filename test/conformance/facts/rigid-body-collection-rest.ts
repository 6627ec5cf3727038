import { LAG, near, ROUGH } from '../checks.js';
import type { Driver, Fact } from '../fact.js';
import { body, collection, G, inertia, WEIGHTLESS } from '../scenes.js';

/** A ball that says nothing itself, drifting at 0.2 m/s and turning at 0.2 rad/s. */
const drifting = (fields: Record<string, unknown>) => [
  collection({
    ...WEIGHTLESS,
    autoDisable: true,
    disableTime: 0.5,
    disableLinearSpeed: 0.3,
    disableAngularSpeed: 0.3,
    bodies: [
      body('ball', {
        inertia: inertia(0.1),
        linearVelocity: [0.2, 0, 0],
        angularVelocity: [0, 0.2, 0],
      }),
    ],
    ...fields,
  }),
];

async function drift(x: Driver, seconds: number): Promise<number> {
  const [from] = await x.get('ball', 'position');
  await x.advance(seconds);
  return (await x.get('ball', 'position'))[0] - from;
}

/** Engines look for what may rest every now and then: 0.3 s at 0.2 m/s. */
const LATE = 0.06;

const preferAccuracy: Fact = {
  field: 'preferAccuracy',
  says: 'TRUE at least halves the error of a fall, unless it is below a millimetre anyway',
  open: 'the field is a hint: a browser may well have one accuracy only',
  scene: [
    collection({ bodies: [body('plain')] }),
    collection({ DEF: 'other', preferAccuracy: true, bodies: [body('accurate')] }),
  ],
  run: async (x) => {
    await x.advance(1);
    const [plain, accurate] = await Promise.all(
      ['plain', 'accurate'].map(async (name) =>
        Math.abs((await x.get(name, 'position'))[1] + G / 2),
      ),
    );
    return [near('error', accurate!, 0, Math.max(plain! / 2, 1e-3), 'm')];
  },
};

export const collectionRest: Fact[] = [
  preferAccuracy,
  {
    field: 'autoDisable',
    says: 'is what bodies do that say nothing themselves: TRUE puts a slow one to rest',
    scene: drifting({ autoDisable: false }),
    run: async (x) => {
      const never = await drift(x, 2);
      await x.set('world', 'autoDisable', true);
      await x.advance(1);
      return [
        near('FALSE, way in 2 s', never, 0.4, 0.4 * ROUGH, 'm'),
        near('TRUE, way in the second after', await drift(x, 1), 0, 1e-4, 'm'),
      ];
    },
  },
  {
    field: 'disableTime',
    says: 'is when slow bodies rest that say nothing themselves',
    scene: drifting({ disableTime: 1.5 }),
    run: async (x) => {
      const long = await drift(x, 3);
      await x.set('world', 'disableTime', 0.5);
      await x.set('ball', 'linearVelocity', [0.2, 0, 0]);
      const short = await drift(x, 3);
      return [
        near('1.5 s, way', long, 0.3 + LATE / 2, LATE / 2 + 0.2 * LAG, 'm'),
        near('0.5 s, way', short, 0.1 + LATE / 2, LATE / 2 + 0.2 * LAG, 'm'),
      ];
    },
  },
  ...['disableLinearSpeed', 'disableAngularSpeed'].map((field): Fact => ({
    field,
    says: 'is below which speed bodies rest that say nothing themselves',
    scene: drifting({ [field]: 0.1 }),
    run: async (x) => {
      const fast = await drift(x, 2);
      await x.set('world', field, 0.3);
      await x.advance(1);
      return [
        near('below its speed, way in 2 s', fast, 0.4, 0.4 * ROUGH, 'm'),
        near('above it, way in the second after', await drift(x, 1), 0, 1e-4, 'm'),
      ];
    },
  })),
];
