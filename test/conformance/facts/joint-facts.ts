import { distance, FRAME, LAG, near, ROUGH } from '../checks.js';
import type { Driver, Fact } from '../fact.js';
import { body, collection, G, inertia, joint, WEIGHTLESS } from '../scenes.js';

// What all joints that have an anchor share.

export const MOMENT = 0.1;
export const ball = (DEF: string, fields: Record<string, unknown> = {}) =>
  body(DEF, { inertia: inertia(MOMENT), ...fields });

/** Something that stands still for joints to hold on to, and collides with nothing. */
export const pin = (fields: Record<string, unknown> = {}) =>
  body('pin', { fixed: true, geometry: [], ...fields });

const height = async (x: Driver, name: string): Promise<number> =>
  (await x.get(name, 'position'))[1];

const fall = (t: number): number => (G * t * t) / 2;

/** Reads an output of `joint`. */
export const output = (x: Driver, field: string) => x.get('joint', field);

/** Two balls, one of them on a joint with the pin; then the joint is told to hold the other. */
function holds(type: string, field: 'body1' | 'body2', fields: Record<string, unknown>): Fact {
  const other = field === 'body1' ? 'body2' : 'body1';
  return {
    field,
    says: `the joint holds whom ${field} names, from the start and from an event on`,
    scene: [
      collection({
        bodies: [pin(), ball('first'), ball('second', { position: [4, 0, 0] })],
        joints: [joint(type, { [field]: 'first', [other]: 'pin' }, { ...fields })],
      }),
    ],
    run: async (x) => {
      const heights = async () => [await height(x, 'first'), await height(x, 'second')];
      await x.advance(0.5);
      const first = await heights();
      await x.set('second', 'position', [4, 0, 0]);
      await x.set('second', 'linearVelocity', [0, 0, 0]);
      await x.set('joint', 'anchorPoint', [4, 0, 0]);
      await x.set('joint', field, { USE: 'second' });
      await x.advance(0.5);
      return [
        near('held and free', first, [0, -fall(0.5)], 4.9 * LAG, 'm'),
        near('free and held', await heights(), [-fall(0.5), 0], 4.9 * LAG, 'm'),
      ];
    },
  };
}

function toWorld(type: string, fields: Record<string, unknown>): Fact {
  return {
    field: 'body2',
    says: 'without a second body the joint holds the first to the world',
    open: 'the other side of a joint with one body is the world',
    scene: [
      collection({ bodies: [ball('first')], joints: [joint(type, { body1: 'first' }, fields)] }),
    ],
    run: async (x) => {
      await x.advance(0.5);
      return [near('height', await height(x, 'first'), 0, 0.01, 'm')];
    },
  };
}

/** A force on one body speeds both up, as one body of their common mass. */
function transmits(type: string, fields: Record<string, unknown>): Fact {
  return {
    field: 'body1',
    says: 'what pulls at one body pulls at both: a = F / (m₁ + m₂), and the joint keeps together',
    scene: [
      collection({
        ...WEIGHTLESS,
        bodies: [
          ball('first', { mass: 3, inertia: inertia(0.3), forces: [[4, 0, 0]] }),
          ball('second', { position: [-2, 0, 0] }),
        ],
        joints: [
          joint(type, { body1: 'first', body2: 'second' }, { anchorPoint: [-1, 0, 0], ...fields }),
        ],
      }),
    ],
    run: async (x) => {
      await x.advance(1);
      const speeds = [];
      for (const name of ['first', 'second']) speeds.push((await x.get(name, 'linearVelocity'))[0]);
      const apart = distance(await x.get('first', 'position'), await x.get('second', 'position'));
      return [
        near('both after 1 s', speeds, [1, 1], LAG, 'm/s'),
        near('distance', apart, 2, 1e-3, 'm'),
      ];
    },
  };
}

/** In a joint that repairs nothing, one anchor moves off the other with its body. */
function carried(type: string, which: 1 | 2, fields: Record<string, unknown>): Fact {
  const moved = which === 1 ? 'first' : 'second';
  return {
    field: `body${which}AnchorPoint`,
    says: `is the anchor as body${which} carries it, along with both bodies and off from the other one's`,
    open: 'in world coordinates, so that both can be compared',
    scene: [
      collection({
        ...WEIGHTLESS,
        errorCorrection: 0,
        bodies: ['first', 'second'].map((name, i) =>
          ball(name, { position: [2 * i, 0, 0], linearVelocity: [0, 1, 0] }),
        ),
        joints: [
          joint(
            type,
            { body1: 'first', body2: 'second' },
            { anchorPoint: [1, 0, 0], forceOutput: ['ALL'], ...fields },
          ),
        ],
      }),
    ],
    run: async (x) => {
      await x.advance(1);
      const along = await output(x, `body${which}AnchorPoint`);
      const [px, py] = await x.get(moved, 'position');
      await x.set(moved, 'position', [px, py, 0.5]);
      await x.advance(FRAME);
      const anchors = [];
      for (const i of [1, 2]) anchors.push((await output(x, `body${i}AnchorPoint`))[2]);
      return [
        near('after 1 s', along, [1, 1, 0], ROUGH, 'm'),
        near('across, body1 and body2', anchors, which === 1 ? [0.5, 0] : [0, 0.5], 0.01, 'm'),
      ];
    },
  };
}

const forceOutput = (type: string, fields: Record<string, unknown>): Fact => ({
  field: 'forceOutput',
  says: 'names the outputs that follow the motion, ALL for each; it changes nothing in the motion',
  scene: [
    collection({
      ...WEIGHTLESS,
      bodies: ['first', 'second'].map((name, i) =>
        ball(name, { position: [2 * i, 0, 0], linearVelocity: [0, 1, 0] }),
      ),
      joints: [
        joint(
          type,
          { body1: 'first', body2: 'second' },
          { anchorPoint: [1, 0, 0], forceOutput: ['body1AnchorPoint'], ...fields },
        ),
      ],
    }),
  ],
  run: async (x) => {
    await x.advance(0.5);
    const named = await output(x, 'body1AnchorPoint');
    await x.set('joint', 'forceOutput', ['ALL']);
    await x.advance(0.5);
    const all = [];
    for (const i of [1, 2]) all.push((await output(x, `body${i}AnchorPoint`))[1]);
    return [
      near('the one that is named', named, [1, 0.5, 0], ROUGH, 'm'),
      near('both, upwards', all, [1, 1], ROUGH, 'm'),
      near('motion', await x.get('first', 'position'), [0, 1, 0], ROUGH, 'm'),
    ];
  },
});

/** `fields`: what else the joint needs, such as an axis along Z. */
export const jointFacts = (type: string, fields: Record<string, unknown> = {}): Fact[] => [
  holds(type, 'body1', fields),
  holds(type, 'body2', fields),
  transmits(type, fields),
  toWorld(type, fields),
  forceOutput(type, fields),
  carried(type, 1, fields),
  carried(type, 2, fields),
];
