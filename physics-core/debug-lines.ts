import type { DebugLines } from './effects/debug/debug-lines.js';
import { outlines } from './effects/debug/debugging.js';
import { deformables } from './effects/deformables/effects.js';
import { ropes } from './effects/soft/effects.js';
import { isJoint } from './nodes/joints/is-joint.js';
import type { World } from './world/world.js';

export type { DebugLines };

/** Draws a started world as Bullet has it, for any renderer: `update()`, then `positions`, `colors` and `count`. */
export async function debugLines(world: World): Promise<DebugLines> {
  await outlines.load();
  return outlines.code.lines(world, {
    flush: () => world.flush(),
    joints: () => [...world.nodes].filter(isJoint),
    matter: () => [
      ...(world.registry.find(ropes)?.all ?? []),
      ...(world.registry.find(deformables)?.all ?? []),
    ],
  });
}
