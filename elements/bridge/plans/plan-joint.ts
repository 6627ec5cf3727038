import type { World } from '../../../physics-core/inside.js';
import type { Binding } from '../nodes/binding.js';
import { collectionNode, nodesIn, type Plan } from './plan.js';
import { jointBody } from '../document/joint-bodies.js';

export function planJoint(binding: Binding, world: World): Plan | undefined {
  const relations: Record<string, unknown> = {};
  for (const side of ['body1', 'body2'] as const) {
    const body = jointBody(binding, side);
    if (body === undefined) relations[side] = null;
    else if (body === 'missing') return undefined;
    else relations[side] = nodesIn(world, [body], binding)[0];
    // Named, but not in this world yet: half a joint would hold its other body to the wrong place.
    if (relations[side] === undefined) return undefined;
  }
  return { world, collection: collectionNode(binding), relations };
}
