import { LAG, near } from '../checks.js';
import type { Driver, Fact } from '../fact.js';
import { body, box, collection, collidable, G, offset, slab, sphere } from '../scenes.js';

const height = async (x: Driver): Promise<number> => (await x.get('stone', 'position'))[1];

/** The skin that some engines leave around shapes, metres. */
const SKIN = 0.01;

/** A body of 1 kg whose one collidable is an offset, just above a floor. */
const above = (y: number, geometry: ReturnType<typeof offset>) => [
  collection({ bodies: [slab(0), body('stone', { position: [0, y, 0], geometry: [geometry] })] }),
];

export const collidableOffset: Fact[] = [
  {
    field: 'translation',
    says: 'places the collidable in the frame of its body: a box a metre below its body rests there',
    scene: above(1.52, offset([0, -1, 0], collidable(box(1)), { DEF: 'offset' })),
    run: async (x) => {
      await x.advance(0.5);
      const first = await height(x);
      await x.set('offset', 'translation', [0, 1, 0]);
      await x.advance(1);
      return [
        near('a metre below', first, 1.5, SKIN, 'm'),
        near('a metre above', await height(x), -0.5, SKIN, 'm'),
      ];
    },
  },
  {
    field: 'rotation',
    says: 'turns the collidable in the frame of its body: a plank of 4 m stands on end under it',
    scene: above(
      2.02,
      offset([0, 0, 0], collidable(box(4, 1, 1)), {
        DEF: 'offset',
        rotation: [0, 0, 1, Math.PI / 2],
      }),
    ),
    run: async (x) => {
      await x.advance(0.5);
      const first = await height(x);
      await x.set('offset', 'rotation', [0, 0, 1, 0]);
      await x.advance(1.5);
      return [near('on end', first, 2, SKIN, 'm'), near('lying', await height(x), 0.5, SKIN, 'm')];
    },
  },
  {
    field: 'enabled',
    says: 'one that is not enabled takes all it holds out of collision',
    scene: above(1.52, offset([0, -1, 0], collidable(box(1)), { DEF: 'offset' })),
    run: async (x) => {
      await x.advance(0.5);
      const first = await height(x);
      await x.set('offset', 'enabled', false);
      await x.advance(0.5);
      return [
        near('enabled', first, 1.5, SKIN, 'm'),
        near('not enabled', await height(x), 1.5 - G / 8, 5 * LAG, 'm'),
      ];
    },
  },
  {
    field: 'collidable',
    says: 'is what it places, also another offset: both displacements add up',
    scene: above(
      1.77,
      offset([0, -1, 0], offset([0, -0.5, 0], collidable(sphere(0.25))), { DEF: 'offset' }),
    ),
    run: async (x) => {
      await x.advance(0.5);
      return [near('an offset in an offset', await height(x), 1.75, SKIN, 'm')];
    },
  },
];
