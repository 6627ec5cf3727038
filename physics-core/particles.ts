// What a page that has particle systems takes of the core, beside inside.ts: it comes in a chunk.
import { particleSystems } from './effects/particles/effects.js';

export { particleTypes } from './nodes/particles/index.js';
export { ParticleSystemNode } from './nodes/particles/particle-system-node.js';
export { PARTICLE } from './effects/particles/cloud.js';
export type { Seen as Shown } from './effects/particles/seen.js';

/** What moves particles; a world asks for it, too, when a system comes. */
export const systemCode = particleSystems.comesFrom(
  () => import('./world/chunks/particle-code.js'),
);
