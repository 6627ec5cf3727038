import type { PhysicsNode } from '../nodes/node/node.js';
import { carrying } from '../effects/drag/effects.js';
import type { LeftOut } from '../world/measuring.js';
import type { World } from '../world/world.js';

/** What acts on a world from outside, and so not on a second one made of its snapshot. */
export function leftOutOf(world: World): LeftOut[] {
  const out: LeftOut[] = [];
  for (const event of ['beforestep', 'afterstep'])
    if (world.heard(event))
      out.push({ element: world.settings.host, reason: `${event} listeners` });
  for (const node of world.nodes)
    for (const reason of outside(node)) out.push({ element: node.host, reason });
  for (const node of world.registry.find(carrying)?.causes ?? [])
    out.push({ element: node.host, reason: 'it is moved along from outside' });
  return out;
}

function* outside(node: PhysicsNode): Generator<string> {
  for (const event of node.heardEvents)
    if (event.startsWith('collision')) yield `${event} listeners`;
  const routed = [...node.fieldState.beforeEvent.keys()];
  if (routed.length > 0) yield `later events to ${routed.join(', ')}`;
}
