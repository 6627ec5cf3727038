import { near, ROUGH, turn } from '../checks.js';
import type { Fact } from '../fact.js';
import { collection, inertia, joint, WEIGHTLESS } from '../scenes.js';
import { ball, jointFacts, output, pin } from './joint-facts.js';
import { axisFact, axisOutputs, place } from './two-axis-facts.js';

const TYPE = 'UniversalJoint';

const axes: Fact[] = [
  axisFact(TYPE, 'axis1', [0, 0, 1], [0, 0.1, 0.1]),
  axisFact(TYPE, 'axis2', [0, 0, 1], [0.1, 0, 0.1]),
  {
    field: 'axis1',
    says: 'a bend is turned round: ω₂ = ω₁ cos β / (1 - sin² β cos² θ), β between the shafts',
    tells: ['mass-ratio'],
    scene: shafts(0.5),
    run: async (x) => {
      const checks = [];
      for (const t of [0.4, 0.8, 1.2]) {
        await x.advance(0.4);
        const rate = (await x.get('driven', 'angularVelocity'))[2] / Math.cos(0.5);
        // The driving arm lies across the plane of both shafts at first.
        const expected = Math.cos(0.5) / (1 - (Math.sin(0.5) * Math.cos(2 * t + Math.PI / 2)) ** 2);
        checks.push(near(`ratio after ${t} s`, rate / 2, expected, 0.03, ''));
      }
      return checks;
    },
  },
];

/** A shaft along Z is driven at 2 rad/s; another leans away from it by β about X. */
function shafts(beta: number) {
  const lean = [0, -Math.sin(beta), Math.cos(beta)];
  return [
    collection({
      ...WEIGHTLESS,
      bodies: [
        ball('driving', { mass: 1000, inertia: inertia(1000), angularVelocity: [0, 0, 2] }),
        ball('driven', {
          inertia: inertia(0.1),
          angularVelocity: lean.map((c) => (2 * c) / Math.cos(beta)),
        }),
      ],
      joints: [
        joint('SingleAxisHingeJoint', { body1: 'driving' }, { DEF: 'one', axis: [0, 0, 1] }),
        joint('SingleAxisHingeJoint', { body1: 'driven' }, { DEF: 'two', axis: lean }),
        joint(
          TYPE,
          { body1: 'driving', body2: 'driven' },
          { axis1: [1, 0, 0], axis2: [0, Math.cos(beta), Math.sin(beta)] },
        ),
      ],
    }),
  ];
}

/** The node has no limits, so nothing may stop, whatever these say. */
const idle: Fact[] = [
  'stop1Bounce',
  'stop1ErrorCorrection',
  'stop2Bounce',
  'stop2ErrorCorrection',
].map((field): Fact => ({
  field,
  says: 'acts on nothing, since the node has no limits: the body turns on past a half turn',
  scene: [
    collection({
      ...WEIGHTLESS,
      bodies: [pin(), ball('ball', { inertia: inertia(1), angularVelocity: [4, 0, 0] })],
      joints: [joint(TYPE, { body1: 'ball', body2: 'pin' }, { [field]: 1 })],
    }),
  ],
  run: async (x) => {
    await x.advance(0.5);
    await x.set('joint', field, 0);
    await x.advance(0.5);
    const turned = turn(await x.get('ball', 'orientation'))[0]!;
    return [
      near('turn', turned, 4 - 2 * Math.PI, 4 * ROUGH, 'rad'),
      near('kept', await output(x, field), 0, 0, ''),
    ];
  },
}));

export const universalJoint: Fact[] = [
  ...jointFacts(TYPE, { axis1: [0, 1, 0], axis2: [0, 0, 1] }),
  place(TYPE),
  ...axes,
  ...axisOutputs(TYPE),
  ...idle,
];
