import { LAG, near } from '../checks.js';
import type { Driver, Fact } from '../fact.js';
import { body, box, collection, collidable, G, slab, sphere, use } from '../scenes.js';

const height = async (x: Driver, name: string): Promise<number> =>
  (await x.get(name, 'position'))[1];

/** The skin that some engines leave around shapes, metres. */
const SKIN = 0.01;

/** A plank that no body holds stands in the way of a ball that falls from just above `y`. */
const obstacle = (y: number, fields: Record<string, unknown>) => [
  collection({
    collider: {
      type: 'CollisionCollection',
      collidables: [
        collidable(box(4, 1, 1), { DEF: 'plank', ...fields }),
        collidable(sphere(0.5), { DEF: 'ballShape' }),
      ],
    },
    bodies: [body('ball', { position: [0, y, 0], geometry: [use('ballShape')] })],
  }),
];

export const collidableShape: Fact[] = [
  {
    field: 'enabled',
    says: 'a shape that is not enabled lets its body fall through the floor; enabled, it holds it up',
    scene: [
      collection({
        bodies: [
          slab(0),
          body('ball', {
            position: [0, 0.5, 0],
            geometry: [collidable(sphere(0.5), { DEF: 'ballShape' })],
          }),
          body('ghost', {
            position: [4, 0.5, 0],
            geometry: [collidable(sphere(0.5), { enabled: false })],
          }),
        ],
      }),
    ],
    run: async (x) => {
      await x.advance(0.5);
      const first = [await height(x, 'ball'), await height(x, 'ghost')];
      await x.set('ballShape', 'enabled', false);
      await x.advance(0.5);
      const way = G / 8;
      return [
        near('enabled', first[0]!, 0.5, SKIN, 'm'),
        near('not enabled from the start', first[1]!, 0.5 - way, 5 * LAG, 'm'),
        near('not enabled any more', await height(x, 'ball'), 0.5 - way, 5 * LAG, 'm'),
      ];
    },
  },
  {
    field: 'shape',
    says: 'its geometry is what collides: each solid rests at its own half height',
    scene: [
      collection({
        bodies: [
          slab(0),
          ...Object.entries({
            box: [box(1, 1.2, 1), 0.6],
            ball: [sphere(0.7), 0.7],
            can: [{ type: 'Cylinder', radius: 0.5, height: 1.4 }, 0.7],
            cone: [{ type: 'Cone', bottomRadius: 1, height: 1 }, 0.5],
          } as const).map(([name, [geometry, half]], i) =>
            body(name, { position: [3 * i, half + 0.02, 0], geometry: [collidable(geometry)] }),
          ),
        ],
      }),
    ],
    run: async (x) => {
      await x.advance(1);
      const heights = await Promise.all(
        ['box', 'ball', 'can', 'cone'].map((name) => height(x, name)),
      );
      return [near('box, ball, cylinder, cone', heights, [0.6, 0.7, 0.7, 0.5], SKIN, 'm')];
    },
  },
  {
    field: 'translation',
    says: 'is where a shape without a body stands: a ball rests on it, and on it again where an event moved it',
    open: 'a collidable of a CollisionCollection that belongs to no body is an obstacle',
    scene: obstacle(3.52, { translation: [0, 2.5, 0] }),
    run: async (x) => {
      await x.advance(0.5);
      const first = await height(x, 'ball');
      await x.set('plank', 'translation', [0, 1.5, 0]);
      await x.advance(1.5);
      return [
        near('on the plank at 2.5 m', first, 3.5, SKIN, 'm'),
        near('on the plank at 1.5 m', await height(x, 'ball'), 2.5, SKIN, 'm'),
      ];
    },
  },
  {
    field: 'rotation',
    says: 'is how a shape without a body is turned: a plank of 4 m on end holds a ball at 2.5 m',
    open: 'a collidable of a CollisionCollection that belongs to no body is an obstacle',
    scene: obstacle(2.52, { rotation: [0, 0, 1, Math.PI / 2] }),
    run: async (x) => {
      await x.advance(0.5);
      const first = await height(x, 'ball');
      await x.set('plank', 'rotation', [0, 0, 1, 0]);
      await x.advance(1.5);
      return [
        near('on end', first, 2.5, SKIN, 'm'),
        near('lying', await height(x, 'ball'), 1, SKIN, 'm'),
      ];
    },
  },
];
