import { Chunk } from '../../base/chunk.js';
import type { EffectDescriptor } from '../effect/effect.js';
import type { Particles } from './particles.js';

export const particleSystems = new Chunk({ name: 'particles', causes: 'a ParticleSystem' });

/** Particles are born, move, meet bodies, and die. */
export const particles: EffectDescriptor<Particles> = {
  name: 'particles',
  causes: 'a ParticleSystem',
  after: { 'free flight': 'what else the wind does' },
  chunk: particleSystems,
};
