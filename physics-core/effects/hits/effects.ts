import { contactSurface } from '../contacts/effects.js';
import { contacts } from '../effect/chunks.js';
import type { EffectDescriptor } from '../effect/effect.js';
import type { ContinuousCollision } from './continuous-collision.js';
import type { ImpactPropagation } from './impact-propagation.js';
import type { SweptEnds } from './swept-ends.js';

/** What passes more than this share of its least extent in a step could pass through something thin. */
export const FAR = 0.5;

export const continuousCollision: EffectDescriptor<ContinuousCollision> = {
  name: 'continuous collision',
  chunk: contacts,
  causes: 'a body that passes more than half its least extent in a step',
};

export const sweptEnds: EffectDescriptor<SweptEnds> = {
  name: 'swept ends',
  chunk: contacts,
  causes: 'a body whose ends go round more than half its least extent in a step',
};

export const impactPropagation: EffectDescriptor<ImpactPropagation> = {
  name: 'impact propagation',
  chunk: contacts,
  causes: 'contacts that say more than the default, or something fast',
  after: { 'free flight': 'what hits is put right from where its free flight would end' },
  with: [contactSurface, continuousCollision],
};
