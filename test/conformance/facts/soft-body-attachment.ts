import type { Fact } from '../fact.js';
import { hanging, hangs } from './rope.js';

// Ours, so all its own fields have rows (test/core/nodes/rows): here stands what any node of X3D has.

export const attachments: Fact[] = [
  {
    field: 'metadata',
    says: 'changes nothing in what it holds',
    inert: true,
    scene: hanging({}, { metadata: { type: 'MetadataString', name: 'note', value: ['knot'] } }),
    run: hangs,
  },
];
