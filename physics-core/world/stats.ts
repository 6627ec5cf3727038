import { isJoint } from '../nodes/joints/is-joint.js';
import type { NodeWorld } from '../nodes/node/node-world.js';
import type { BodySlots } from './bodies/body-slots.js';
import type { Stepping } from './stepping/stepping.js';
import type { Stats } from './store/types.js';

export function statsOf(
  world: NodeWorld & { bodies: BodySlots },
  { ms, dropped }: Pick<Stepping, 'ms' | 'dropped'>,
): Stats {
  let joints = 0;
  for (const node of world.nodes) if (isJoint(node) && node.attached) joints++;
  return {
    bodies: world.bodies.count,
    awake: world.bodies.countAwake(),
    joints,
    contacts: world.started ? world.bullet.contactCount : 0,
    ...world.counts,
    heapBytes: world.engine?.heapBytes ?? 0,
    dropped,
    ms: { ...ms },
  };
}
