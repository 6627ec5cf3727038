// What a page that has water takes of the core, beside inside.ts: it comes in a chunk.
import { chunks } from './world/chunks/all.js';
import { swimming, waters, waveChunk } from './effects/water/effects.js';

export { waterTypes } from './nodes/water/index.js';
export type { ShownSurface } from './effects/water/moving-surface.js';
export { WaterVolumeNode } from './nodes/water/water-volume-node.js';

/** What moves in water; a world asks for it, too, when a volume comes. */
export const waterCode = waters.comesFrom(() => import('./world/chunks/water-code.js'));

// A volume whose surface is to move waits for the one; for the other all that gives way, and volumes beside that.
chunks.push(
  waveChunk.comesFrom(() => import('./effects/wave-code.js')),
  swimming.comesFrom(() => import('./effects/swim-code.js')),
);
