import { JointNode } from '../nodes/joint.js';
import type { Stats } from './types.js';
import type { World } from './world.js';

export function statsOf(world: World): Stats {
  let joints = 0;
  for (const node of world.nodes) if (node instanceof JointNode && node.attached) joints++;
  return {
    bodies: world.bodies.count,
    awake: world.bodies.countAwake(),
    joints,
    contacts: world.started ? world.bullet.contactCount : 0,
    ...world.counts,
    heapBytes: world.engine?.heapBytes ?? 0,
    ms: { ...world.stepping.ms },
  };
}
