import { lateWorlds } from '../document/world-for.js';
import { worldAround } from '../matter/world-of.js';
import { planners } from '../plans/plans.js';
import { planAttachment, worldOfAttachment } from './plan-attachment.js';
import { planRope } from './plan-rope.js';

/** Has what reads the document place ropes, and what ties them. */
export function placeRopes(): void {
  planners.Rope = planRope;
  lateWorlds.Rope = worldAround;
  planners.SoftBodyAttachment = planAttachment;
  lateWorlds.SoftBodyAttachment = worldOfAttachment;
}
