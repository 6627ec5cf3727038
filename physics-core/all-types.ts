// The tables of all nodes, for what is written about each of them. No page imports it: some come in a chunk.
import type { NodeType } from './inside.js';
import { nodeTypes } from './nodes/index.js';
import { byName } from './nodes/node/table.js';
import { particleTypes } from './nodes/particles/index.js';
import { deformableTypes } from './nodes/soft/deformable-types.js';
import { softTypes } from './nodes/soft/index.js';
import { waterTypes } from './nodes/water/index.js';

export const allTypes: Readonly<Record<string, NodeType>> = byName({
  ...nodeTypes,
  ...particleTypes,
  ...softTypes,
  ...deformableTypes,
  ...waterTypes,
});
