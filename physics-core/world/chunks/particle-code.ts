// The chunk `particles`.
import { provideParticleEffects } from '../../effects/particle-code.js';
import { lateTypes } from '../../nodes/late.js';
import { particleTypes } from '../../nodes/particles/index.js';

export function provide(): void {
  provideParticleEffects();
  Object.assign(lateTypes, particleTypes);
}
