import { Chunk } from '../../../physics-core/inside.js';
import { lowerName } from '../words/dom.js';

/** How tags of X3D's component of particle systems end. */
const PARTICLES = /(particle-?system|emitter|physics-?model)$/;

/** What reads them. */
export const particleTags = new Chunk({ name: 'particle-elements', causes: 'a ParticleSystem' });

/** Whether nobody reads its tag yet, but code that may be had perhaps does. */
export const isLate = (element: Element): boolean =>
  !particleTags.here && PARTICLES.test(lowerName(element));
