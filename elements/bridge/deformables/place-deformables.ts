import { deformableTypes } from '../../../physics-core/deformables.js';
import { lateWorlds } from '../document/world-for.js';
import { worldAround } from '../matter/world-of.js';
import { planners } from '../plans/plans.js';
import { planDeformable } from './plan-deformable.js';

/** Has what reads the document place cloth and soft bodies. */
export function placeDeformables(): void {
  for (const name of Object.keys(deformableTypes)) {
    planners[name] = planDeformable;
    lateWorlds[name] = worldAround;
  }
}
