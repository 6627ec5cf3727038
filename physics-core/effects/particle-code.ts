// Effects of the chunk `particles`.
import { particles } from './particles/effects.js';
import { Particles } from './particles/particles.js';

export function provideParticleEffects(): void {
  particles.load = (simulation, effects) => new Particles(simulation, effects);
}
