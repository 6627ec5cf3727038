// What a page that has cloth or soft bodies takes of the core, beside inside.ts: it comes in a chunk.
import { deformableChunk } from './effects/deformables/effects.js';

export { deformableTypes } from './nodes/soft/deformable-types.js';
export { sheet } from './nodes/soft/sheet.js';
export { DeformableNode } from './nodes/soft/deformable-node.js';

/** What moves them; a world asks for it, too, when one comes. */
export const deformableCode = deformableChunk.comesFrom(
  () => import('./world/chunks/deformable-code.js'),
);
