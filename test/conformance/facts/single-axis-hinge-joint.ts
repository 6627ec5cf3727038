import { FRAME, LAG, near, ROUGH, turn } from '../checks.js';
import type { Driver, Fact } from '../fact.js';
import { pendulum, solve } from '../reference.js';
import { box, collection, collidable, inertia, joint, WEIGHTLESS } from '../scenes.js';
import { ball, jointFacts, MOMENT, output, pin } from './joint-facts.js';

const TYPE = 'SingleAxisHingeJoint';
const Z = { axis: [0, 0, 1] };

/** A box of a metre on a hinge about Z through its centre, without weight; its moment is the same by field and shape. */
const wheel = (hinge: object, fields: object = {}) => [
  collection({
    ...WEIGHTLESS,
    bodies: [
      pin(),
      ball('wheel', { geometry: [collidable(box(1))], inertia: inertia(1 / 6), ...fields }),
    ],
    joints: [
      joint(TYPE, { body1: 'wheel', body2: 'pin' }, { ...Z, forceOutput: ['ALL'], ...hinge }),
    ],
  }),
];

const spinning = (rate: number) => ({ angularVelocity: [0, 0, rate] });

const angle = async (x: Driver): Promise<number> => turn(await x.get('wheel', 'orientation'))[2]!;
const rate = async (x: Driver): Promise<number> => (await x.get('wheel', 'angularVelocity'))[2];

const place: Fact[] = [
  {
    field: 'anchorPoint',
    says: 'is where the axis runs: a ball hangs below it, and swings as a pendulum once it lies beside the ball',
    scene: [
      collection({
        bodies: [
          pin({ position: [5, 5, 5], orientation: [0, 0.6, 0.8, 2] }),
          ball('ball', { orientation: [0.6, 0, 0.8, 1] }),
        ],
        joints: [joint(TYPE, { body1: 'ball', body2: 'pin' }, { ...Z, anchorPoint: [0, 1, 0] })],
      }),
    ],
    run: async (x) => {
      await x.advance(0.5);
      const hanging = await x.get('ball', 'position');
      await x.set('joint', 'anchorPoint', [1, 0, 0]);
      await x.advance(0.8);
      const [swung] = solve(pendulum(1, MOMENT), [-Math.PI / 2, 0], 0.8) as [number];
      const expected = [1 + Math.sin(swung), -Math.cos(swung), 0];
      return [
        near('hanging', hanging, [0, 0, 0], 0.005, 'm'),
        // A frame at its greatest speed.
        near('0.8 s on', await x.get('ball', 'position'), expected, 4.2 * LAG, 'm'),
      ];
    },
  },
  {
    field: 'axis',
    says: 'is the one direction a torque can turn the body in: about Z, and about X once that is the axis',
    scene: wheel({}, { torques: [[1 / 6, 1 / 6, 1 / 6]] }),
    run: async (x) => {
      await x.advance(0.5);
      const first = await x.get('wheel', 'angularVelocity');
      await x.set('wheel', 'angularVelocity', [0, 0, 0]);
      await x.set('joint', 'axis', [1, 0, 0]);
      await x.advance(0.5);
      return [
        near('about Z', first, [0, 0, 0.5], LAG, 'rad/s'),
        near('about X', await x.get('wheel', 'angularVelocity'), [0.5, 0, 0], LAG, 'rad/s'),
      ];
    },
  },
  {
    field: 'axis',
    says: 'goes with its bodies: both turn about it freely while they turn together about another',
    scene: [
      collection({
        ...WEIGHTLESS,
        bodies: ['first', 'second'].map((name, i) =>
          ball(name, {
            position: [0, 2 * i, 0],
            inertia: inertia(1),
            // Together about X through the middle of both.
            linearVelocity: [0, 0, 2 * i - 1],
            angularVelocity: [1, 0, 0],
          }),
        ),
        joints: [
          joint(
            TYPE,
            { body1: 'first', body2: 'second' },
            { axis: [0, 1, 0], anchorPoint: [0, 1, 0] },
          ),
        ],
      }),
    ],
    run: async (x) => {
      await x.advance(1);
      const turned = turn(await x.get('first', 'orientation'));
      const place = await x.get('second', 'position');
      return [
        near('both turn', turned, [1, 0, 0], ROUGH, 'rad'),
        near('second', place, [0, 1 + Math.cos(1), Math.sin(1)], ROUGH, 'm'),
      ];
    },
  },
];

/** Until the wheel has turned to its stop, and a while. */
async function toStop(x: Driver, speed: number): Promise<number> {
  await x.set('wheel', 'angularVelocity', [0, 0, speed]);
  await x.advance(1);
  return angle(x);
}

const stops: Fact[] = [
  ...(['minAngle', 'maxAngle'] as const).map((field): Fact => {
    const sign = field === 'minAngle' ? -1 : 1;
    return {
      field,
      says: 'is a stop: the wheel turns to it and no further, and further once it is moved',
      scene: wheel({ minAngle: -0.5, maxAngle: 0.5 }, spinning(sign * 2)),
      run: async (x) => {
        await x.advance(1);
        const first = await angle(x);
        await x.set('joint', field, sign * 0.9);
        const second = await toStop(x, sign * 2);
        return [
          near('at 0.5', first, sign * 0.5, 0.02, 'rad'),
          near('at 0.9', second, sign * 0.9, 0.02, 'rad'),
        ];
      },
    };
  }),
  {
    field: 'stopBounce',
    says: 'is the share of its rate with which the wheel comes back from a stop',
    scene: wheel({ maxAngle: 0.5, stopBounce: 0.8 }, spinning(2)),
    run: async (x) => {
      await x.advance(0.5);
      const first = await rate(x);
      await x.set('joint', 'stopBounce', 0.3);
      await x.set('wheel', 'orientation', [0, 0, 1, 0]);
      await x.set('wheel', 'angularVelocity', [0, 0, 2]);
      await x.advance(0.5);
      return [
        near('at 0.8', first, -1.6, 0.05, 'rad/s'),
        near('at 0.3', await rate(x), -0.6, 0.05, 'rad/s'),
      ];
    },
  },
  {
    field: 'stopErrorCorrection',
    says: 'is the share of an overshoot that a frame repairs',
    open: 'per frame of 1/60 s, whatever the step of the browser',
    scene: wheel({ maxAngle: 0.5, stopErrorCorrection: 0.3 }),
    run: async (x) => {
      const left = async () => {
        await x.set('wheel', 'orientation', [0, 0, 1, 0.7]);
        await x.set('wheel', 'angularVelocity', [0, 0, 0]);
        await x.advance(FRAME);
        return (await angle(x)) - 0.5;
      };
      await x.advance(FRAME);
      const first = await left();
      await x.set('joint', 'stopErrorCorrection', 0.6);
      return [
        near('left of 0.2 rad at 0.3', first, 0.14, 0.005, 'rad'),
        near('left of 0.2 rad at 0.6', await left(), 0.08, 0.005, 'rad'),
      ];
    },
  },
];

/** Two wheels on one axis that turn against each other. */
const both = [
  collection({
    ...WEIGHTLESS,
    bodies: [
      ball('first', { geometry: [], orientation: [0, 0, 1, 0.4], angularVelocity: [0, 0, 2] }),
      ball('second', { geometry: [], orientation: [1, 0, 0, 1], angularVelocity: [0, 0, -1] }),
    ],
    joints: [
      joint(
        TYPE,
        { body1: 'first', body2: 'second' },
        { ...Z, forceOutput: ['angle', 'angleRate'] },
      ),
    ],
  }),
];

const outputs: Fact[] = [
  {
    field: 'angle',
    says: 'is how far body1 has turned about the axis against body2 since the joint was made',
    open: 'the sign: body1 relative to body2, as in the engine the component was made after',
    scene: both,
    run: async (x) => {
      await x.advance(0.5);
      return [near('after 0.5 s at 3 rad/s', await output(x, 'angle'), 1.5, 3 * LAG, 'rad')];
    },
  },
  {
    field: 'angleRate',
    says: 'is how fast body1 turns about the axis against body2',
    open: 'the sign: body1 relative to body2, as in the engine the component was made after',
    scene: both,
    run: async (x) => {
      await x.advance(0.5);
      return [near('2 against -1 rad/s', await output(x, 'angleRate'), 3, 0.02, 'rad/s')];
    },
  },
];

export const singleAxisHingeJoint: Fact[] = [
  ...jointFacts(TYPE, Z),
  ...place,
  ...stops,
  ...outputs,
];
