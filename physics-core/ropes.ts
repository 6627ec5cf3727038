// What a page that has ropes takes of the core, beside inside.ts: it comes in a chunk.
import { ropeChunk } from './effects/soft/effects.js';

export { softTypes } from './nodes/soft/index.js';
export { RopeNode } from './nodes/soft/rope-node.js';

/** What moves ropes; a world asks for it, too, when one comes. */
export const ropeCode = ropeChunk.comesFrom(() => import('./world/chunks/rope-code.js'));
