import { particleTypes } from '../../../physics-core/particles.js';
import { lateWorlds } from '../document/world-for.js';
import { planners } from '../plans/plans.js';
import { planPart, worldOfPart } from './plan-part.js';
import { planSystem, worldOfSystem } from './plan-system.js';

/** Has what reads the document place particle systems, and what stands in them. */
export function placeParticles(): void {
  for (const name of Object.keys(particleTypes)) {
    planners[name] = planPart;
    lateWorlds[name] = worldOfPart;
  }
  planners.ParticleSystem = planSystem;
  lateWorlds.ParticleSystem = worldOfSystem;
}
