import { createWorld } from '../../physics-core/create.js';
import type { Plan } from './plan.js';
import { Scene } from './scene.js';

/** Simulated seconds before the end of what is recorded, to which it is gone back one after the other. */
const BACK = [0, 0.1, 0.35, 1.1];

/**
 * Plays a plan while it is recorded, and goes on from ever earlier moments of it: throws where what is run anew is not where
 * it was. The recording looks for itself.
 */
export async function lookBack(plan: Plan): Promise<void> {
  const world = await createWorld({ gravity: plan.gravity, accuracy: plan.level });
  try {
    const timeline = await world.record();
    const scene = new Scene(world, { ...plan, wild: true });
    for (let step = 0; step < plan.steps; step++) scene.step(step, plan.edits);
    const { to } = timeline;
    for (const back of BACK) {
      timeline.seek(to - back);
      world.resume();
      const diverged = world.problems.find(({ code }) => code === 'run-diverged');
      if (diverged) throw new Error(`${back} s before ${to} s: ${diverged.message}`);
    }
  } finally {
    world.destroy();
  }
}
