import { near } from '../checks.js';
import type { Fact, NodeData } from '../fact.js';
import { body, collection, use } from '../scenes.js';

// Ours, so all its own fields have rows (test/core/nodes/rows): here stands what any node of X3D has.

/** A ball hangs from the middle of the lower edge of a cloth. */
const hanging = (fields: Record<string, unknown> = {}): NodeData[] => [
  collection({
    bodies: [
      body('ball', { position: [0, -1, 0] }),
      {
        type: 'Cloth',
        DEF: 'cloth',
        geometry: {
          type: 'IndexedTriangleSet',
          index: [0, 2, 1],
          coord: { type: 'Coordinate', point: [-0.5, 0, 0, 0.5, 0, 0, 0, -1, 0] },
        },
        thickness: 0,
        fixedIndex: [0, 1],
        ...fields,
      },
      { type: 'SoftBodyAttachment', softBody: use('cloth'), index: 2, body: use('ball') },
    ],
  }),
];

export const cloths: Fact[] = [
  {
    field: 'visible',
    says: 'FALSE: it holds all the same',
    inert: true,
    scene: hanging({ visible: false }),
    run: async (x) => {
      await x.advance(1);
      return [near('after a second', await x.get('ball', 'position'), [0, -1, 0], 5e-3, 'm')];
    },
  },
];

export const softBodies: Fact[] = [
  {
    field: 'visible',
    says: 'FALSE: it falls all the same',
    inert: true,
    scene: [
      collection({
        bodies: [
          body('ball', { position: [0, 2, 0] }),
          {
            type: 'SoftBody',
            DEF: 'soft',
            youngsModulus: 1e4,
            geometry: { type: 'Box', size: [1, 1, 1] },
            visible: false,
          },
        ],
      }),
    ],
    run: async (x) => {
      await x.advance(1);
      const [, y] = ((await x.get('soft', 'positions')) as number[][])[0]!;
      return [near('after a second', Math.abs(y!), 4.9, 0.6, 'm')];
    },
  },
];
