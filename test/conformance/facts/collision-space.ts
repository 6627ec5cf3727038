import type { Driver, Fact, NodeData } from '../fact.js';
import { body, box, collection, collidable, sphere, use } from '../scenes.js';

/** A ball over a fixed block; the block is in the collider only by a space within a space. */
const nested = (inner: object = {}): NodeData[] => [
  collection({
    gravity: [0, -9.8, 0],
    collider: {
      type: 'CollisionCollection',
      DEF: 'collider',
      collidables: [
        use('ballShape'),
        {
          type: 'CollisionSpace',
          DEF: 'outer',
          collidables: [
            { type: 'CollisionSpace', DEF: 'inner', collidables: [use('blockShape')], ...inner },
          ],
        },
      ],
    },
    bodies: [
      body('block', {
        fixed: true,
        position: [0, -1, 0],
        geometry: [collidable(box(2), { DEF: 'blockShape' })],
      }),
      body('ball', {
        position: [0, 0.5, 0],
        geometry: [collidable(sphere(0.5), { DEF: 'ballShape' })],
      }),
    ],
  }),
];

/** How far the ball has gone down half a second after it was put on the block. */
async function sinks(x: Driver): Promise<number> {
  await x.set('ball', 'position', [0, 0.5, 0]);
  await x.set('ball', 'linearVelocity', [0, 0, 0]);
  await x.advance(0.5);
  return 0.5 - (await x.get('ball', 'position'))[1];
}

/** ½ g t² in half a second, and up to 1/60 s of error in time at 4.9 m/s. */
const FREE = { expected: (9.8 * 0.25) / 2, tolerance: 0.085, unit: 'm' };
const HELD = { expected: 0, tolerance: 0.01, unit: 'm' };

/** A table of one mesh whose legs are 0.8 m high, over a ball of 0.2 m. */
const slab = (x: number, y: number, halfX: number, halfY: number): number[] =>
  [0, 1, 2, 3, 4, 5, 6, 7].flatMap((i) => [
    x + (i & 1 ? halfX : -halfX),
    y + (i & 2 ? halfY : -halfY),
    i & 4 ? 0.5 : -0.5,
  ]);
const FACES = [
  0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7,
  1, 7, 5,
];
const table: NodeData = {
  type: 'IndexedTriangleSet',
  coord: {
    type: 'Coordinate',
    point: [...slab(0, 0.4, 1, 0.1), ...slab(-0.9, -0.1, 0.1, 0.4), ...slab(0.9, -0.1, 0.1, 0.4)],
  },
  index: [0, 8, 16].flatMap((first) => FACES.map((i) => i + first)),
};

export const collisionSpace: Fact[] = [
  {
    field: 'enabled',
    says: 'a disabled space takes its members out of the collection, at any depth',
    tells: ['not-in-collider'],
    scene: nested(),
    run: async (x) => {
      const held = await sinks(x);
      await x.set('inner', 'enabled', false);
      const inner = await sinks(x);
      await x.set('inner', 'enabled', true);
      await x.set('outer', 'enabled', false);
      const outer = await sinks(x);
      await x.set('outer', 'enabled', true);
      return [
        { what: 'enabled', actual: held, ...HELD },
        { what: 'inner disabled', actual: inner, ...FREE },
        { what: 'outer disabled', actual: outer, ...FREE },
        { what: 'enabled again', actual: await sinks(x), ...HELD },
      ];
    },
  },
  {
    field: 'collidables',
    says: 'what is put into a space collides, what is taken out of it does not',
    tells: ['not-in-collider', 'not-in-collider'],
    scene: nested({ collidables: [] }),
    run: async (x) => {
      const empty = await sinks(x);
      await x.set('inner', 'collidables', [use('blockShape')]);
      const put = await sinks(x);
      await x.set('outer', 'collidables', []);
      return [
        { what: 'empty', actual: empty, ...FREE },
        { what: 'put in', actual: put, ...HELD },
        { what: 'its space taken out', actual: await sinks(x), ...FREE },
      ];
    },
  },
  {
    field: 'useGeometry',
    says: 'TRUE: a moving concave mesh stands on its own feet over a ball that fits under it',
    scene: [
      collection({
        gravity: [0, -9.8, 0],
        bodies: [
          body('ground', {
            fixed: true,
            position: [0, -0.5, 0],
            geometry: [collidable(box(20, 1, 20))],
          }),
          body('ball', { position: [0, 0.2, 0], geometry: [collidable(sphere(0.2))] }),
          body('table', {
            position: [0, 0.6, 0],
            geometry: [collidable(table, { DEF: 'tableShape' })],
          }),
        ],
      }),
      {
        type: 'CollisionCollection',
        collidables: [
          {
            type: 'CollisionSpace',
            DEF: 'space',
            useGeometry: true,
            collidables: [use('tableShape')],
          },
        ],
      },
    ],
    run: async (x) => {
      await x.advance(1);
      const feet = (await x.get('table', 'position'))[1];
      const ball = await x.get('ball', 'position');
      return [
        { what: 'height of the table', actual: feet, expected: 0.5, tolerance: 0.01, unit: 'm' },
        {
          what: 'the ball under it',
          actual: ball,
          expected: [0, 0.2, 0],
          tolerance: 0.01,
          unit: 'm',
        },
      ];
    },
  },
];
