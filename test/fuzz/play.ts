import { createWorld } from '../../physics-core/create.js';
import { type World } from '../../physics-core/inside.js';
import type { OwnedObjects } from './heap.js';
import type { Plan } from './plan.js';
import { Scene } from './scene.js';

/** Seconds of the processor that one run may take. */
const LONGEST = 10;

/** Problems that no values of an author may bring about: they are faults of ours. */
const FAULTS = ['edit-failed', 'heap-exhausted', 'nan-state'];

/** Plays a plan and throws where something is wrong. */
export async function play(plan: Plan, owned: OwnedObjects): Promise<void> {
  const before = owned.count;
  await playOnce(plan);
  if (owned.count === before) return;
  // What all worlds share is made when the first one needs it.
  const shared = owned.count;
  await playOnce(plan);
  if (owned.count !== shared)
    throw new Error(`${owned.count - shared} objects stay on the heap: ${owned.since(shared)}`);
}

async function playOnce(plan: Plan): Promise<void> {
  const start = process.cpuUsage();
  const world = await createWorld({ gravity: plan.gravity, accuracy: plan.level });
  try {
    const scene = new Scene(world, plan);
    for (let step = 0; step < plan.steps; step++) {
      scene.step(step, plan.edits);
      judge(world, scene, step);
    }
  } finally {
    world.destroy();
  }
  const { user, system } = process.cpuUsage(start);
  const seconds = (user + system) / 1e6;
  if (seconds > LONGEST) throw new Error(`a run took ${seconds} s`);
}

function judge(world: World, scene: Scene, step: number): void {
  const problem = world.problems.find(({ code }) => FAULTS.includes(code));
  const fault = problem ? `${problem.code}: ${problem.message}` : scene.fault;
  if (fault) throw new Error(`step ${step}: ${fault}`);
}
