import { particleTypes } from '../physics-core/particles.js';
import { forType } from './node-element.js';

/**
 * Particles that an emitter bears, models of physics move, and time takes away; drawn in one call.
 *
 * What stands in a Transform that a body moves is carried by that body.
 */
export class X3DParticleSystemElement extends forType(
  'ParticleSystem',
  undefined,
  particleTypes.ParticleSystem,
) {}

declare global {
  interface HTMLElementTagNameMap {
    'x3d-particle-system': X3DParticleSystemElement;
  }
}
