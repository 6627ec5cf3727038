import { near } from '../checks.js';
import type { Fact } from '../fact.js';
import { body, box, collection, collidable } from '../scenes.js';

// Ours, so all its own fields have rows (test/core/nodes/rows): here stands what any node of X3D has.

/** Half as heavy as water. */
const raft = body('raft', { mass: 500, geometry: [collidable(box(1))] });

export const waterVolume: Fact[] = [
  {
    field: 'visible',
    says: 'FALSE: what floats in it does so all the same',
    inert: true,
    scene: [
      collection({
        bodies: [raft, { type: 'WaterVolume', position: [0, -1, 0], visible: false }],
      }),
    ],
    run: async (x) => {
      await x.advance(1);
      return [
        near('position after a second', await x.get('raft', 'position'), [0, 0, 0], 1e-3, 'm'),
      ];
    },
  },
];
