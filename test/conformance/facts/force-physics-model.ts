import { near } from '../checks.js';
import type { Driver, Fact, NodeData } from '../fact.js';
import { EXACT, furthest, LOOK, places, point, pushes, system } from './particle-scenes.js';

/** A force on particles of half a kilogram that are thrown along X at 2 m/s. */
const pushed = (fields = {}): NodeData[] =>
  system(point({ speed: 2, mass: 0.5 }), {
    physics: [{ type: 'ForcePhysicsModel', DEF: 'model', ...fields }],
  });

export const modelEnabled = (scene: NodeData[], acceleration: number[]): Fact => ({
  field: 'enabled',
  says: 'FALSE: it does nothing to particles, until an event makes it act, and from another on again',
  scene,
  run: async (x: Driver) => {
    const off = async (from: number[]): Promise<number> => furthest(await pushes(x), from);
    await x.advance(LOOK);
    const before = await off([0, 0, 0]);
    await x.set('model', 'enabled', true);
    const acting = await off(acceleration);
    await x.set('model', 'enabled', false);
    return [
      near('acceleration before', before, 0, 100 * EXACT, 'm/s²'),
      near('off what it does', acting, 0, 100 * EXACT, 'm/s²'),
      near('acceleration after', await off([0, 0, 0]), 0, 100 * EXACT, 'm/s²'),
    ];
  },
});

const force: Fact[] = [
  {
    field: 'force',
    says: 'makes x = v t + ½ (F / m) t², t being the age of a particle',
    scene: pushed({ force: [0, -4.9, 1] }),
    run: async (x) => {
      await x.advance(LOOK);
      const age = LOOK;
      const [oldest] = await places(x);
      const expected = [2 * age, -4.9 * age ** 2, age ** 2];
      return [near('the oldest', oldest!, expected, EXACT, 'm')];
    },
  },
  {
    field: 'force',
    says: 'acts on all particles from an event on',
    scene: pushed({ force: [1, 0, 0] }),
    run: async (x) => {
      await x.advance(LOOK);
      const before = furthest(await pushes(x), [2, 0, 0]);
      await x.set('model', 'force', [0, 0, 3]);
      return [
        near('off (2, 0, 0) m/s²', before, 0, 100 * EXACT, 'm/s²'),
        near('off (0, 0, 6) m/s²', furthest(await pushes(x), [0, 0, 6]), 0, 100 * EXACT, 'm/s²'),
      ];
    },
  },
  {
    field: 'force',
    says: 'is (0, -9.8, 0) where nothing is said',
    scene: pushed(),
    run: async (x) => {
      await x.advance(LOOK);
      const off = furthest(await pushes(x), [0, -19.6, 0]);
      return [near('off (0, -19.6, 0) m/s²', off, 0, 100 * EXACT, 'm/s²')];
    },
  },
];

export const forcePhysicsModel: Fact[] = [
  ...force,
  modelEnabled(pushed({ enabled: false, force: [1, 2, 3] }), [2, 4, 6]),
];
