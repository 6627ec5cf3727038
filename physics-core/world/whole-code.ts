import type { Chunk } from '../base/chunk.js';
import { particleSystems } from '../effects/particles/effects.js';
import { deformableChunk } from '../effects/deformables/effects.js';
import { ropeChunk } from '../effects/soft/effects.js';
import { swimming, waters, waveChunk } from '../effects/water/effects.js';
import { dense } from './snapshot/dense.js';
import { chunks } from './chunks/all.js';

/** All code that a world may need which is shown none of it before: that of a worker. */
export const wholeCode: readonly Chunk<unknown>[] = [
  dense,
  particleSystems.comesFrom(() => import('./chunks/particle-code.js')),
  waters.comesFrom(() => import('./chunks/water-code.js')),
  ropeChunk.comesFrom(() => import('./chunks/rope-code.js')),
  deformableChunk.comesFrom(() => import('./chunks/deformable-code.js')),
  waveChunk.comesFrom(() => import('../effects/wave-code.js')),
  swimming.comesFrom(() => import('../effects/swim-code.js')),
  ...chunks,
];
