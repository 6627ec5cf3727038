import { FRAME, holds, LAG, near, ROUGH, turn } from '../checks.js';
import type { Fact } from '../fact.js';
import { body, box, collection, collidable, G, inertia, slab } from '../scenes.js';
import { alone, mass } from './rigid-body-mass.js';
import { damping, rest } from './rigid-body-rest.js';

/** Way of a fall from rest, metres. */
const fall = (t: number): number => (G * t * t) / 2;

const place: Fact[] = [
  {
    field: 'position',
    says: 'is where the body starts and is; an event moves it there at once and it keeps its velocity',
    scene: [collection({ bodies: [body('ball', { position: [1, 2, 3] })] })],
    run: async (x) => {
      const start = await x.get('ball', 'position');
      await x.advance(0.5);
      const fallen = await x.get('ball', 'position');
      await x.set('ball', 'position', [3, 20, -2]);
      await x.advance(0.5);
      const moved = await x.get('ball', 'position');
      return [
        near('start', start, [1, 2, 3], 1e-5, 'm'),
        // A frame more or less at the speed of the end.
        near('after 0.5 s', fallen, [1, 2 - fall(0.5), 3], 4.9 * LAG, 'm'),
        near('0.5 s on', moved, [3, 20 - 4.9 * 0.5 - fall(0.5), -2], 3.7 * ROUGH, 'm'),
      ];
    },
  },
  {
    field: 'orientation',
    says: 'is how the body is turned; an event turns it at once and it keeps its spin',
    scene: alone({ orientation: [1, 0, 0, 0.3], angularVelocity: [0, 0, 0] }),
    run: async (x) => {
      const start = turn(await x.get('ball', 'orientation'));
      await x.set('ball', 'angularVelocity', [0, 0, 2]);
      await x.set('ball', 'orientation', [0, 0, 1, 1]);
      await x.advance(0.5);
      const turned = turn(await x.get('ball', 'orientation'));
      return [
        near('start', start, [0.3, 0, 0], 1e-5, 'rad'),
        near('0.5 s on at 2 rad/s', turned, [0, 0, 2], ROUGH, 'rad'),
      ];
    },
  },
  {
    field: 'linearVelocity',
    says: 'carries the body by v t, from the start and from an event on',
    scene: alone({ linearVelocity: [1, 0, 0] }),
    run: async (x) => {
      await x.advance(0.5);
      const first = await x.get('ball', 'position');
      await x.set('ball', 'linearVelocity', [0, 2, -3]);
      await x.advance(0.5);
      return [
        near('after 0.5 s', first, [0.5, 0, 0], LAG, 'm'),
        near('0.5 s on', await x.get('ball', 'position'), [0.5, 1, -1.5], 3 * LAG, 'm'),
        near('velocity', await x.get('ball', 'linearVelocity'), [0, 2, -3], 1e-3, 'm/s'),
      ];
    },
  },
  {
    field: 'angularVelocity',
    says: 'turns the body by ω t about its direction, from the start and from an event on',
    scene: alone({ angularVelocity: [0, 1, 0] }),
    run: async (x) => {
      await x.advance(0.5);
      const first = turn(await x.get('ball', 'orientation'));
      await x.set('ball', 'angularVelocity', [0, 3, 0]);
      await x.advance(0.5);
      return [
        near('after 0.5 s', first, [0, 0.5, 0], LAG, 'rad'),
        near('0.5 s on', turn(await x.get('ball', 'orientation')), [0, 2, 0], 3 * LAG, 'rad'),
        near('spin', await x.get('ball', 'angularVelocity'), [0, 3, 0], 1e-3, 'rad/s'),
      ];
    },
  },
  {
    field: 'fixed',
    says: 'a fixed body holds up what lies on it, falls once it is let go, and stands still when fixed again',
    scene: [
      collection({
        bodies: [
          body('shelf', { fixed: true, position: [0, 5, 0], geometry: [collidable(box(4, 1, 4))] }),
          body('ball', { position: [0, 6, 0] }),
        ],
      }),
    ],
    run: async (x) => {
      const height = async (name: string) => (await x.get(name, 'position'))[1] as number;
      await x.advance(1);
      const held = [await height('shelf'), await height('ball')];
      await x.set('shelf', 'fixed', false);
      await x.advance(0.5);
      const free = await height('shelf');
      await x.set('shelf', 'fixed', true);
      // An event may take a frame to act.
      await x.advance(FRAME);
      const caught = await height('shelf');
      await x.advance(0.5);
      return [
        // 1 cm for the skin that some engines leave around shapes.
        near('held', held, [5, 6], 0.01, 'm'),
        near('let go, after 0.5 s', free, 5 - fall(0.5), ROUGH * fall(0.5), 'm'),
        near('fixed again, way in 0.5 s', caught - (await height('shelf')), 0, 1e-3, 'm'),
      ];
    },
  },
  {
    field: 'enabled',
    says: 'a body that is not enabled stands still and lets others through; enabled again it falls on',
    scene: [
      collection({
        bodies: [
          slab(0),
          body('ball', { position: [0, 0.5, 0] }),
          body('free', { position: [9, 9, 0] }),
        ],
      }),
    ],
    run: async (x) => {
      const height = async (name: string) => (await x.get(name, 'position'))[1] as number;
      await x.advance(0.5);
      const resting = await height('ball');
      await x.set('slab', 'enabled', false);
      await x.set('free', 'enabled', false);
      const [ball, free] = [await height('ball'), await height('free')];
      await x.advance(0.5);
      const after = [await height('ball'), await height('free')];
      await x.set('free', 'enabled', true);
      await x.advance(0.5);
      return [
        near('resting on the slab', resting, 0.5, 0.01, 'm'),
        near('fallen through it', ball - after[0]!, fall(0.5), ROUGH * fall(0.5), 'm'),
        near('not enabled, way', free - after[1]!, 0, 5 * LAG, 'm'),
        // Whether it keeps the velocity it had is left open: it falls at least as from rest.
        holds('falls on', after[1]! - (await height('free')) > fall(0.5) - 5 * LAG),
      ];
    },
  },
];

const loads: Fact[] = [
  {
    field: 'forces',
    says: 'their sum acts at the centre of mass until they are taken away: v = F t / m',
    scene: alone({
      mass: 2,
      forces: [
        [3, 1, 0],
        [1, 1, 0],
      ],
    }),
    run: async (x) => {
      await x.advance(0.5);
      const pushed = await x.get('ball', 'linearVelocity');
      await x.set('ball', 'forces', []);
      await x.advance(0.5);
      return [
        near('after 0.5 s', pushed, [1, 0.5, 0], 2 * LAG, 'm/s'),
        near('without', await x.get('ball', 'linearVelocity'), pushed, 2 * LAG, 'm/s'),
        near('spin', await x.get('ball', 'angularVelocity'), [0, 0, 0], 1e-5, 'rad/s'),
      ];
    },
  },
  {
    field: 'torques',
    says: 'their sum turns the body until they are taken away: ω = τ t / I',
    // A box, since its moment is the same by the field and by its shape.
    scene: alone({
      geometry: [collidable(box(1))],
      inertia: inertia(1 / 6),
      torques: [
        [0, 0.1, 0],
        [0, 0.2, 0],
      ],
    }),
    run: async (x) => {
      await x.advance(0.5);
      const turned = await x.get('ball', 'angularVelocity');
      await x.set('ball', 'torques', []);
      await x.advance(0.5);
      return [
        near('after 0.5 s', turned, [0, 0.9, 0], 2 * LAG, 'rad/s'),
        near('without', await x.get('ball', 'angularVelocity'), turned, 2 * LAG, 'rad/s'),
        near('way', await x.get('ball', 'position'), [0, 0, 0], 1e-5, 'm'),
      ];
    },
  },
  {
    field: 'useGlobalGravity',
    says: 'without it a falling body keeps its speed',
    scene: [collection({ bodies: [body('ball')] })],
    run: async (x) => {
      const speed = async () => (await x.get('ball', 'linearVelocity'))[1] as number;
      await x.advance(0.5);
      const first = await speed();
      await x.set('ball', 'useGlobalGravity', false);
      await x.advance(0.5);
      const second = await speed();
      await x.set('ball', 'useGlobalGravity', true);
      await x.advance(0.5);
      return [
        near('falling', first, -G / 2, G * LAG, 'm/s'),
        near('without', second, -G / 2, G * LAG, 'm/s'),
        near('with it again', await speed(), -G, G * LAG, 'm/s'),
      ];
    },
  },
];

export const rigidBody: Fact[] = [...place, ...mass, ...loads, ...damping, ...rest];
