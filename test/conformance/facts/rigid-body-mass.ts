import { aboutZ, LAG, near, rotated } from '../checks.js';
import type { Fact } from '../fact.js';
import { body, box, collection, collidable, inertia, slab, sphere, WEIGHTLESS } from '../scenes.js';

/** A lone ball without weight. */
export const alone = (fields: Record<string, unknown> = {}) => [
  collection({ ...WEIGHTLESS, bodies: [body('ball', { inertia: inertia(0.1), ...fields })] }),
];

export const mass: Fact[] = [
  {
    field: 'mass',
    says: 'the same force speeds a body of five times the mass up by a fifth: a = F/m',
    scene: alone({ forces: [[10, 0, 0]] }),
    run: async (x) => {
      await x.advance(0.5);
      const light = await x.get('ball', 'linearVelocity');
      await x.set('ball', 'mass', 5);
      await x.advance(0.5);
      const heavy = await x.get('ball', 'linearVelocity');
      return [
        near('at 1 kg', light, [5, 0, 0], 10 * LAG, 'm/s'),
        near('at 5 kg', heavy, [6, 0, 0], 10 * LAG, 'm/s'),
      ];
    },
  },
  {
    field: 'inertia',
    says: 'is the tensor of α = I⁻¹ τ, off-diagonal terms included',
    scene: alone({ inertia: inertia(1, 1, 6), torques: [[0, 0, 3]] }),
    run: async (x) => {
      await x.advance(1);
      const straight = await x.get('ball', 'angularVelocity');
      await x.set('ball', 'torques', []);
      await x.set('ball', 'orientation', [0, 0, 1, 0]);
      await x.set('ball', 'angularVelocity', [0, 0, 0]);
      // I = [[2,1,0],[1,2,0],[0,0,1]] has I⁻¹ (0.6,0,0) = (0.4,-0.2,0); so slow that the body hardly turns.
      await x.set('ball', 'inertia', [2, 1, 0, 1, 2, 0, 0, 0, 1]);
      await x.set('ball', 'torques', [[0.6, 0, 0]]);
      await x.advance(0.25);
      const oblique = await x.get('ball', 'angularVelocity');
      return [
        near('about Z, 6 kg·m²', straight, [0, 0, 0.5], 0.5 * LAG, 'rad/s'),
        near('oblique', oblique, [0.1, -0.05, 0], 0.5 * LAG, 'rad/s'),
      ];
    },
  },
  {
    field: 'inertia',
    says: 'a free body of three different moments keeps its angular momentum, so that its axis of spin wanders',
    scene: alone({ inertia: inertia(1, 2, 3), angularVelocity: [2, 2, 0] }),
    run: async (x) => {
      await x.advance(1);
      const [x1, y1, z1, angle] = await x.get('ball', 'orientation');
      const spin = rotated(await x.get('ball', 'angularVelocity'), [x1, y1, z1, -angle]);
      const inBody = spin.map((rate, i) => rate * (i + 1));
      const momentum = rotated(inBody, [x1, y1, z1, angle]);
      // 5 % of its 4.5 kg·m²/s.
      return [near('angular momentum after 1 s', momentum, [2, 4, 0], 0.22, 'kg·m²/s')];
    },
  },
  {
    field: 'centerOfMass',
    says: 'a torque turns the body about its centre of mass, which stays where it is',
    scene: alone({ centerOfMass: [-1, 0, 0], inertia: inertia(1) }),
    run: async (x) => {
      const turned = async () => {
        await x.set('ball', 'torques', [[0, 0, 2]]);
        await x.advance(1);
        return x.get('ball', 'position');
      };
      const first = await turned();
      // To rest, and back to where it was.
      await x.set('ball', 'torques', []);
      await x.set('ball', 'angularVelocity', [0, 0, 0]);
      await x.set('ball', 'linearVelocity', [0, 0, 0]);
      await x.set('ball', 'orientation', [0, 0, 1, 0]);
      await x.set('ball', 'position', [0, 0, 0]);
      await x.set('ball', 'centerOfMass', [1, 0, 0]);
      const second = await turned();
      // Half a radian per s² · 2: 1 rad in the second.
      const about = (centre: number[]) =>
        aboutZ(
          centre.map((value) => -value),
          1,
        ).map((value, i) => value + centre[i]!);
      return [
        near('centre at -1 0 0', first, about([-1, 0, 0]), 2 * LAG, 'm'),
        near('centre at 1 0 0', second, about([1, 0, 0]), 2 * LAG, 'm'),
      ];
    },
  },
  {
    field: 'massDensityModel',
    says: 'gives the body the moment of its own solid: 2/5 m r² of a sphere, m (a² + b²)/12 of a box',
    open: 'inertia that is not written comes from the model, not from the default of the field',
    scene: [
      collection({
        ...WEIGHTLESS,
        bodies: [body('ball', { massDensityModel: sphere(2), torques: [[0, 1, 0]] })],
      }),
    ],
    run: async (x) => {
      await x.advance(1);
      const round = await x.get('ball', 'angularVelocity');
      await x.set('ball', 'angularVelocity', [0, 0, 0]);
      await x.set('ball', 'massDensityModel', box(3, 1, 1));
      await x.advance(1);
      const boxed = await x.get('ball', 'angularVelocity');
      return [
        near('sphere of 2 m', round, [0, 1 / 1.6, 0], LAG, 'rad/s'),
        near('box of 3 × 1 × 1 m', boxed, [0, 12 / 10, 0], 1.2 * LAG, 'rad/s'),
      ];
    },
  },
  {
    field: 'geometry',
    says: 'is the shape that collides: a ball of 0.5 m that becomes a box of 2 m rests at 1 m',
    scene: [collection({ bodies: [slab(0), body('stone', { position: [0, 0.5, 0] })] })],
    run: async (x) => {
      await x.advance(0.5);
      const round = await x.get('stone', 'position');
      await x.set('stone', 'position', [0, 1.2, 0]);
      await x.set('stone', 'geometry', [collidable(box(2))]);
      await x.advance(1.5);
      return [
        near('as a ball', round, [0, 0.5, 0], 0.01, 'm'),
        near('as a box', await x.get('stone', 'position'), [0, 1, 0], 0.01, 'm'),
      ];
    },
  },
];
