import { LAG, near } from '../checks.js';
import type { Driver, Fact } from '../fact.js';
import { collection, inertia, joint, WEIGHTLESS } from '../scenes.js';
import { ball, output, pin } from './joint-facts.js';

const TYPE = 'MotorJoint';
const SIGN = 'the sign: body1 relative to body2, as in the engine the component was made after';

type Fields = Record<string, unknown>;

/** A ball of 1 kg·m², turned by a motor against the pin. */
const driven = (motor: Fields, fields: Fields = {}) => [
  collection({
    ...WEIGHTLESS,
    bodies: [pin(), ball('ball', { inertia: inertia(1), ...fields })],
    joints: [joint(TYPE, { body1: 'ball', body2: 'pin' }, { forceOutput: ['ALL'], ...motor })],
  }),
];

const spin = (x: Driver) => x.get('ball', 'angularVelocity');

/** From rest at no turn. */
async function again(x: Driver): Promise<void> {
  await x.set('ball', 'orientation', [0, 0, 1, 0]);
  await x.set('ball', 'angularVelocity', [0, 0, 0]);
}

const unit = (n: number, size = 1): number[] => [1, 2, 3].map((i) => (i === n ? size : 0));

const bodies: Fact[] = (['body1', 'body2'] as const).map((field): Fact => ({
  field,
  says: 'the torque acts on whom it names now: plus on body1, minus on body2',
  scene: [
    collection({
      ...WEIGHTLESS,
      bodies: ['a', 'b', 'c'].map((name, i) =>
        ball(name, { inertia: inertia(1), position: [3 * i, 0, 0] }),
      ),
      joints: [joint(TYPE, { body1: 'a', body2: 'b' }, { axis1Torque: 2 })],
    }),
  ],
  run: async (x) => {
    const spins = async () => {
      const all = [];
      for (const name of ['a', 'b', 'c']) all.push((await x.get(name, 'angularVelocity'))[0]);
      return all;
    };
    await x.advance(0.5);
    const before = await spins();
    await x.set('joint', field, { USE: 'c' });
    await x.advance(0.5);
    const after = field === 'body1' ? [1, -2, 1] : [2, -1, -1];
    return [
      near('a, b, c', before, [1, -1, 0], 2 * LAG, 'rad/s'),
      near('after the edit', await spins(), after, 4 * LAG, 'rad/s'),
    ];
  },
}));

const enabled: Fact = {
  field: 'enabledAxes',
  says: 'is how many axes are driven, from the first on',
  scene: driven({ axis1Torque: 1, axis2Torque: 2, axis3Torque: 3, enabledAxes: 0 }),
  run: async (x) => {
    const checks = [];
    for (const n of [0, 1, 2, 3]) {
      await again(x);
      await x.set('joint', 'enabledAxes', n);
      await x.advance(0.2);
      const expected = [1, 2, 3].map((i) => (i <= n ? 0.2 * i : 0));
      // The axes turn with the ball, by 0.07 rad.
      checks.push(near(`${n} axes`, await spin(x), expected, 3 * LAG + 0.03, 'rad/s'));
    }
    return checks;
  },
};

const ofAxis = (n: 1 | 2 | 3): Fact[] => [
  {
    field: `motor${n}Axis`,
    says: 'is the direction that its torque turns about, of whatever length',
    tells: ['idle-motor'],
    scene: driven({ enabledAxes: 3, [`axis${n}Torque`]: 1 }),
    run: async (x) => {
      await x.advance(0.5);
      const first = await spin(x);
      await again(x);
      await x.set('joint', `motor${n}Axis`, [0, 3, 4]);
      await x.advance(0.5);
      const second = await spin(x);
      await again(x);
      await x.set('joint', `motor${n}Axis`, [0, 0, 0]);
      await x.advance(0.5);
      return [
        near('the default', first, unit(n, 0.5), LAG, 'rad/s'),
        near('slanting', second, [0, 0.3, 0.4], LAG, 'rad/s'),
        near('none', await spin(x), [0, 0, 0], LAG, 'rad/s'),
      ];
    },
  },
  {
    field: `axis${n}Torque`,
    says: 'turns the body by dω/dt = τ / I',
    scene: driven({ enabledAxes: 3, [`axis${n}Torque`]: 1 }),
    run: async (x) => {
      await x.advance(0.5);
      const first = await spin(x);
      await x.set('joint', `axis${n}Torque`, -3);
      await x.advance(0.5);
      return [
        near('at 1 N·m', first, unit(n, 0.5), LAG, 'rad/s'),
        near('then -3 N·m', await spin(x), unit(n, -1), 4 * LAG, 'rad/s'),
      ];
    },
  },
  {
    field: `axis${n}Angle`,
    says: 'is the angle as the author measured it: the motor says it again, and turns nothing by it',
    open: 'in user mode the author tells the angle',
    tells: ['idle-motor'],
    scene: driven({ enabledAxes: 3, [`axis${n}Angle`]: 0.5 }),
    run: async (x) => {
      await x.advance(0.2);
      const first = await output(x, `motor${n}Angle`);
      await x.set('joint', `axis${n}Angle`, -0.75);
      await x.advance(0.2);
      return [
        near('told', first, 0.5, 1e-6, 'rad'),
        near('told again', await output(x, `motor${n}Angle`), -0.75, 1e-6, 'rad'),
        near('at rest', await spin(x), [0, 0, 0], 0, 'rad/s'),
      ];
    },
  },
  ...(['Bounce', 'ErrorCorrection'] as const).map((what): Fact => ({
    field: `stop${n}${what}`,
    says: 'acts on nothing, since the node has no limits: the body turns on past a half turn',
    scene: driven({ enabledAxes: 3, [`stop${n}${what}`]: 1 }, { angularVelocity: unit(n, 4) }),
    run: async (x) => {
      await x.advance(1);
      await x.set('joint', `stop${n}${what}`, 0.25);
      await x.advance(1);
      return [
        near('still', await spin(x), unit(n, 4), 1e-3, 'rad/s'),
        near('kept', await output(x, `stop${n}${what}`), 0.25, 1e-6, ''),
      ];
    },
  })),
  {
    field: `motor${n}AngleRate`,
    says: `is how fast body1 turns about axis ${n} against body2`,
    open: SIGN,
    scene: driven({ enabledAxes: 3 }, { angularVelocity: unit(n, 2) }),
    run: async (x) => {
      await x.advance(0.5);
      const first = await output(x, `motor${n}AngleRate`);
      await x.set('ball', 'angularVelocity', unit(n, -1));
      await x.advance(0.5);
      return [
        near('2 rad/s', first, 2, 0.01, 'rad/s'),
        near('-1 rad/s', await output(x, `motor${n}AngleRate`), -1, 0.01, 'rad/s'),
      ];
    },
  },
];

/** The Euler axes at the start: axis 2 is axis 3 × axis 1. */
const EULER = { 1: [1, 0, 0], 2: [0, 1, 0], 3: [0, 0, 1] };

const euler: Fact[] = [
  ...([1, 2, 3] as const).map((n): Fact => ({
    field: `motor${n}Angle`,
    says: `with autoCalc it is how far body1 has turned about axis ${n} against body2`,
    open: SIGN,
    scene: driven(
      { autoCalc: true, enabledAxes: 3 },
      { angularVelocity: EULER[n].map((c) => 2 * c) },
    ),
    run: async (x) => {
      await x.advance(0.5);
      const all = [];
      for (const i of [1, 2, 3]) all.push(await output(x, `motor${i}Angle`));
      return [near('all three', all, unit(n, 1), 2 * LAG, 'rad')];
    },
  })),
  {
    field: 'autoCalc',
    says: 'measures the angles: a body that turns about its own third axis after the others has these Euler angles',
    open: 'body1 carries axis 1, body2 axis 3',
    tells: ['idle-motor'],
    scene: driven({ autoCalc: true, enabledAxes: 3, axis1Angle: 2 }),
    run: async (x) => {
      await x.advance(0.1);
      // Turned about X, then Y, then Z of the pin: quaternion product z · y · x.
      await x.set('ball', 'orientation', turns(0.3, -0.4, 0.5));
      await x.advance(0.1);
      const all = [];
      for (const i of [1, 2, 3]) all.push(await output(x, `motor${i}Angle`));
      return [near('angles', all, [0.3, -0.4, 0.5], 1e-3, 'rad')];
    },
  },
  {
    field: 'autoCalc',
    says: 'axis 1 turns with body1 and axis 3 stays with body2',
    scene: driven(
      { autoCalc: true, enabledAxes: 3, axis3Torque: 1 },
      { orientation: [0, 1, 0, 0] },
    ),
    run: async (x) => {
      await x.set('ball', 'orientation', [0, 1, 0, 1]);
      await x.advance(0.5);
      return [near('about Z of the pin', await spin(x), [0, 0, 0.5], LAG, 'rad/s')];
    },
  },
];

/** Axis and angle of a turn about X, then Y, then Z. */
function turns(x: number, y: number, z: number): number[] {
  const [a, b, c] = [x, y, z].map((t) => [Math.cos(t / 2), Math.sin(t / 2)]) as [number, number][];
  const w = c![0] * b![0] * a![0] + c![1] * b![1] * a![1];
  const v = [
    c![0] * b![0] * a![1] - c![1] * b![1] * a![0],
    c![0] * b![1] * a![0] + c![1] * b![0] * a![1],
    c![1] * b![0] * a![0] - c![0] * b![1] * a![1],
  ];
  const s = Math.hypot(...v);
  return [...v.map((value) => value / s), 2 * Math.atan2(s, w)];
}

const forceOutput: Fact = {
  field: 'forceOutput',
  says: 'names the outputs that follow the motion, ALL for each; it changes nothing in the motion',
  scene: driven(
    { forceOutput: ['motor1AngleRate'], enabledAxes: 3 },
    { angularVelocity: [2, 0, 0] },
  ),
  run: async (x) => {
    await x.advance(0.5);
    const named = await output(x, 'motor1AngleRate');
    await x.set('joint', 'forceOutput', ['ALL']);
    await x.advance(0.5);
    return [
      near('the one that is named', named, 2, 0.01, 'rad/s'),
      near('all', await output(x, 'motor1AngleRate'), 2, 0.01, 'rad/s'),
      near('motion', await spin(x), [2, 0, 0], 1e-3, 'rad/s'),
    ];
  },
};

export const motorJoint: Fact[] = [
  ...bodies,
  enabled,
  ...([1, 2, 3] as const).flatMap(ofAxis),
  ...euler,
  forceOutput,
];
