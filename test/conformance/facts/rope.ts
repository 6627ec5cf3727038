import { near } from '../checks.js';
import type { Fact, NodeData } from '../fact.js';
import { body, collection, use } from '../scenes.js';

// Ours, so all its own fields have rows (test/core/nodes/rows): here stands what any node of X3D has.

/** A ball hangs from a rope. */
export const hanging = (
  fields: Record<string, unknown> = {},
  ofTie: Record<string, unknown> = {},
): NodeData[] => [
  collection({
    bodies: [
      body('ball', { position: [0, -2, 0] }),
      {
        type: 'Rope',
        DEF: 'rope',
        points: [0, 0, 0, 0, -2, 0],
        segments: 4,
        radius: 0,
        fixedIndex: [0],
        ...fields,
      },
      {
        type: 'SoftBodyAttachment',
        softBody: use('rope'),
        index: 4,
        body: use('ball'),
        ...ofTie,
      },
    ],
  }),
];

export const hangs: Fact['run'] = async (x) => {
  await x.advance(1);
  return [near('after a second', await x.get('ball', 'position'), [0, -2, 0], 1e-3, 'm')];
};

export const ropes: Fact[] = [
  {
    field: 'visible',
    says: 'FALSE: it holds all the same',
    inert: true,
    scene: hanging({ visible: false }),
    run: hangs,
  },
];
