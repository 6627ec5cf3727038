import { LAG, near, turn } from '../checks.js';
import type { Fact } from '../fact.js';
import { body, collection, G, joint, WEIGHTLESS } from '../scenes.js';
import { ball, output, pin } from './joint-facts.js';
import { at, bead, FREE, pair, SIGN, speed, TYPE, X } from './slider-scenes.js';
import { stops } from './slider-stops.js';

const fall = (t: number): number => (G * t * t) / 2;

function holds(field: 'body1' | 'body2'): Fact {
  const other = field === 'body1' ? 'body2' : 'body1';
  return {
    field,
    says: `the rail holds whom ${field} names, from the start and from an event on`,
    scene: [
      collection({
        bodies: [pin(), ball('one', { position: [1, 0, 0] }), ball('two', { position: [3, 0, 0] })],
        joints: [joint(TYPE, { [field]: 'one', [other]: 'pin' }, X)],
      }),
    ],
    run: async (x) => {
      const heights = async () => [
        (await x.get('one', 'position'))[1],
        (await x.get('two', 'position'))[1],
      ];
      await x.advance(0.5);
      const before = await heights();
      await x.set('two', 'position', [3, 0, 0]);
      await x.set('two', 'linearVelocity', [0, 0, 0]);
      await x.set('joint', field, { USE: 'two' });
      await x.advance(0.5);
      return [
        near('held and free', before, [0, -fall(0.5)], 4.9 * LAG, 'm'),
        near('free and held', await heights(), [-fall(0.5), 0], 4.9 * LAG, 'm'),
      ];
    },
  };
}

const bodies: Fact[] = [
  holds('body1'),
  holds('body2'),
  {
    field: 'body2',
    says: 'without a second body the first slides along the axis against the world',
    open: 'the other side of a joint with one body is the world, and body1 along the axis is positive',
    scene: [
      collection({
        bodies: [ball('bead', { linearVelocity: [1, 0, 0] })],
        joints: [joint(TYPE, { body1: 'bead' }, { ...X, ...FREE, forceOutput: ['ALL'] })],
      }),
    ],
    run: async (x) => {
      await x.advance(0.5);
      return [
        near('bead', await x.get('bead', 'position'), [0.5, 0, 0], LAG, 'm'),
        near('separation', await output(x, 'separation'), 0.5, LAG, 'm'),
      ];
    },
  },
  {
    field: 'body1',
    says: 'a torque on one body turns both about their common centre, as one body: neither turns against the other',
    scene: pair({}, { torques: [[0, 0, 2]] }),
    run: async (x) => {
      await x.advance(0.5);
      const turns = [];
      for (const name of ['first', 'second'])
        turns.push(turn(await x.get(name, 'orientation'))[2]!);
      // Both balls' own 0.1 kg·m², and 1 and 3 kg at 3 and 1 m.
      const expected = (2 / 12.2) * 0.125;
      return [near('both', turns, [expected, expected], 2 * LAG * 0.1, 'rad')];
    },
  },
];

const axis: Fact[] = [
  {
    field: 'axis',
    says: 'is the one direction a force can move the body in: along X, and along the new one once it is edited',
    scene: bead(FREE, { forces: [[2, 2, 2]] }),
    run: async (x) => {
      await x.advance(0.5);
      const first = await x.get('bead', 'linearVelocity');
      await x.set('bead', 'linearVelocity', [0, 0, 0]);
      await x.set('joint', 'axis', [0, 3, 4]);
      await x.advance(0.5);
      return [
        near('along X', first, [0.5, 0, 0], LAG, 'm/s'),
        // The force of (2, 2, 2) N has 2.8 N along (0, 0.6, 0.8).
        near('slanting', await x.get('bead', 'linearVelocity'), [0, 0.42, 0.56], 1.4 * LAG, 'm/s'),
      ];
    },
  },
  {
    field: 'axis',
    says: 'goes with its bodies: they slide apart while both turn',
    scene: pair(
      {},
      { linearVelocity: [-3, -3, 0], angularVelocity: [0, 0, 1] },
      { linearVelocity: [1, 1, 0], angularVelocity: [0, 0, 1] },
    ),
    run: async (x) => {
      await x.advance(0.5);
      const [one, two] = [await x.get('first', 'position'), await x.get('second', 'position')];
      // The angular momentum of 12.2 kg·m² s⁻¹ stays, ¾ r² + 0.2 grows; the reference is Runge and Kutta's.
      const away = [two[0] - one[0], two[1] - one[1]];
      const turned = turn(await x.get('first', 'orientation'))[2]!;
      return [
        near(
          'the line between them and their turn',
          Math.atan2(away[1]!, away[0]!),
          turned,
          0.01,
          'rad',
        ),
        near('separation', await output(x, 'separation'), Math.hypot(...away) - 4, 0.01, 'm'),
      ];
    },
  },
];

const force: Fact[] = [
  {
    field: 'sliderForce',
    says: 'pushes both bodies apart, F / m each; a negative one pulls them together',
    open: SIGN,
    scene: pair({ sliderForce: 6 }),
    run: async (x) => {
      await x.advance(0.5);
      const apart = [await speed(x, 'first'), await speed(x, 'second')];
      await x.set('joint', 'sliderForce', -6);
      await x.advance(1);
      return [
        near('at 6 N', apart, [-3, 1], 6 * LAG, 'm/s'),
        near(
          'at -6 N',
          [await speed(x, 'first'), await speed(x, 'second')],
          [3, -1],
          12 * LAG,
          'm/s',
        ),
      ];
    },
  },
  {
    field: 'sliderForce',
    says: 'makes x = ½ (F / m) t² of a body against a fixed one',
    scene: bead({ ...FREE, sliderForce: 3 }),
    run: async (x) => {
      await x.advance(1);
      return [near('way', await at(x, 'bead'), 0.75, 1.5 * LAG, 'm')];
    },
  },
  {
    field: 'sliderForce',
    says: 'gives no turn to bodies whose centres lie beside the axis at rest: what it does to one it undoes at the other',
    scene: [
      collection({
        ...WEIGHTLESS,
        bodies: [body('first'), body('second', { position: [2, 1, 0] })],
        joints: [
          joint(TYPE, { body1: 'first', body2: 'second' }, { ...X, ...FREE, sliderForce: 0.5 }),
        ],
      }),
    ],
    run: async (x) => {
      await x.advance(0.5);
      const [one, two] = [await x.get('first', 'position'), await x.get('second', 'position')];
      const middle = [0, 1, 2].map((i) => (one[i] + two[i]) / 2);
      return [near('their common centre', middle, [1, 0.5, 0], 1e-3, 'm')];
    },
  },
];

const outputs: Fact[] = [
  {
    field: 'separation',
    says: 'is how far they slid apart since the joint was made',
    open: SIGN,
    scene: pair({}, { linearVelocity: [-1, 0, 0] }, { linearVelocity: [0.5, 0, 0] }),
    run: async (x) => {
      await x.advance(0.5);
      return [near('at 1.5 m/s', await output(x, 'separation'), 0.75, 1.5 * LAG, 'm')];
    },
  },
  {
    field: 'separationRate',
    says: 'is how fast they slide apart',
    open: SIGN,
    scene: pair({}, { linearVelocity: [-1, 0, 0] }, { linearVelocity: [0.5, 0, 0] }),
    run: async (x) => {
      await x.advance(0.5);
      return [near('rate', await output(x, 'separationRate'), 1.5, 0.01, 'm/s')];
    },
  },
  {
    field: 'forceOutput',
    says: 'names the outputs that follow the motion, ALL for each; it changes nothing in the motion',
    scene: pair({ forceOutput: ['separation'] }, { linearVelocity: [-1, 0, 0] }),
    run: async (x) => {
      await x.advance(0.5);
      const named = await output(x, 'separation');
      await x.set('joint', 'forceOutput', ['ALL']);
      await x.advance(0.5);
      return [
        near('the one that is named', named, 0.5, LAG, 'm'),
        near(
          'both',
          [await output(x, 'separation'), await output(x, 'separationRate')],
          [1, 1],
          LAG,
          'm, m/s',
        ),
        near('motion', await at(x, 'first'), -1, LAG, 'm'),
      ];
    },
  },
];

export const sliderJoint: Fact[] = [...bodies, ...axis, ...stops, ...force, ...outputs];
