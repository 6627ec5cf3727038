import { Chunk } from '../../../physics-core/inside.js';
import { isPhysics, lowerName } from '../words/dom.js';

/** X3D's component of particle systems. */
const PARTICLES =
  /^(x3d-)?(particle-?system|(point|cone|explosion|polyline|surface|volume)-?emitter|(bounded|force|wind)-?physics-?model)$/;

/** Their tags, and what becomes of them. */
export const particleTags = new Chunk({ name: 'particle-elements', causes: 'a ParticleSystem' });

/** Whether nobody reads its tag yet, but code that may be had does. */
export const isLate = (element: Element): boolean =>
  PARTICLES.test(lowerName(element)) && !isPhysics(element);
