import { LAG, near } from '../checks.js';
import type { Driver, Fact } from '../fact.js';
import { pendulum, solve } from '../reference.js';
import { collection, inertia, joint, WEIGHTLESS } from '../scenes.js';
import { ball, MOMENT, output, pin } from './joint-facts.js';

// What the joints about two axes share.

export const spin = (x: Driver) => x.get('ball', 'angularVelocity');

/** The ball swings about axis1, which is Z. */
export const place = (type: string): Fact => ({
  field: 'anchorPoint',
  says: 'is where the axes meet: a ball hangs below it, and swings as a pendulum once it lies beside the ball',
  scene: [
    collection({
      bodies: [
        pin({ position: [5, 5, 5], orientation: [0, 0.6, 0.8, 2] }),
        ball('ball', { orientation: [0.6, 0, 0.8, 1] }),
      ],
      joints: [
        joint(
          type,
          { body1: 'ball', body2: 'pin' },
          { axis1: [0, 0, 1], axis2: [1, 0, 0], anchorPoint: [0, 1, 0] },
        ),
      ],
    }),
  ],
  run: async (x) => {
    await x.advance(0.5);
    const hanging = await x.get('ball', 'position');
    await x.set('joint', 'anchorPoint', [1, 0, 0]);
    await x.advance(0.8);
    const [swung] = solve(pendulum(1, MOMENT), [-Math.PI / 2, 0], 0.8) as [number];
    return [
      near('hanging', hanging, [0, 0, 0], 0.005, 'm'),
      near(
        '0.8 s on',
        await x.get('ball', 'position'),
        [1 + Math.sin(swung), -Math.cos(swung), 0],
        // A frame or two at its greatest speed.
        4.2 * LAG,
        'm',
      ),
    ];
  },
});

/** Torques about all three axes turn the ball about both axes, and not about what is at right angles to them. */
export const axisFact = (
  type: string,
  field: 'axis1' | 'axis2',
  edit: number[],
  second: number[],
): Fact => ({
  field,
  says: 'is a direction to turn about: bodies turn about both axes, and not about what is at right angles to them',
  scene: [
    collection({
      ...WEIGHTLESS,
      bodies: [pin(), ball('ball', { inertia: inertia(1), torques: [[1, 1, 1]] })],
      joints: [joint(type, { body1: 'pin', body2: 'ball' })],
    }),
  ],
  run: async (x) => {
    await x.advance(0.1);
    const before = await spin(x);
    await x.set('ball', 'orientation', [0, 0, 1, 0]);
    await x.set('ball', 'angularVelocity', [0, 0, 0]);
    await x.set('joint', field, edit);
    await x.advance(0.1);
    return [
      near('about X and Y', before, [0.1, 0.1, 0], LAG, 'rad/s'),
      near('after the edit', await spin(x), second, LAG, 'rad/s'),
    ];
  },
});

/** Where the axes point. */
export const axisOutputs = (type: string): Fact[] =>
  ([1, 2] as const).map((n) => ({
    field: `body${n}Axis`,
    says: `is where axis${n} points now, carried by body${n}`,
    open: 'in world coordinates',
    scene: [
      collection({
        ...WEIGHTLESS,
        bodies: [
          pin(),
          ball('ball', { inertia: inertia(1), angularVelocity: n === 1 ? [0, 1, 0] : [1, 0, 0] }),
        ],
        joints: [
          joint(type, n === 1 ? { body1: 'ball', body2: 'pin' } : { body1: 'pin', body2: 'ball' }, {
            forceOutput: ['ALL'],
          }),
        ],
      }),
    ],
    run: async (x) => {
      await x.advance(1);
      const expected = n === 1 ? [Math.cos(1), 0, -Math.sin(1)] : [0, Math.cos(1), Math.sin(1)];
      const other = n === 1 ? [0, 1, 0] : [1, 0, 0];
      return [
        near('this one', await output(x, `body${n}Axis`), expected, LAG, ''),
        near('the other', await output(x, `body${3 - n}Axis`), other, 1e-3, ''),
      ];
    },
  }));
