import { createWorld } from '../../physics-core/create.js';
import { World } from '../../physics-core/inside.js';
import { copyInto } from '../../physics-core/world/snapshot/copy.js';
import { softPlaces } from './numbers.js';
import type { Plan } from './plan.js';
import { Scene } from './scene.js';

/** Steps that are seen, and gone through again from the snapshot before them; and restores of each snapshot. */
const STEPS = 25;
const RESTORES = 2;

/** Everything that moves, to the last bit, by its id. */
const stateOf = (world: World): number[] => [
  ...[...world.bodies]
    .sort((a, b) => a.id - b.id)
    .flatMap((body) => [
      body.id,
      ...body.readPose(new Float64Array(7)),
      ...world.bodies.velocityOf(body),
      +body.sleeping,
    ]),
  ...softPlaces(world),
];

function runOf(world: World): number[][] {
  const states = [stateOf(world)];
  for (let step = 0; step < STEPS; step++) {
    world.step();
    states.push(stateOf(world));
  }
  return states;
}

/**
 * Plays a plan, and in the middle of its edits goes back again and again: throws where the run after a restore is another
 * than the one that was seen, here or in a world made of the snapshot. Hands and listeners, which act from outside, are
 * left out.
 */
export async function playBack(plan: Plan): Promise<void> {
  const edits = plan.edits.filter(({ when, act }) => 'step' in when && act.act !== 'drag');
  const world = await createWorld({ gravity: plan.gravity, accuracy: plan.level });
  try {
    const scene = new Scene(world, { ...plan, edits, wild: true });
    for (let step = 0; step < plan.steps; step++) {
      scene.step(step, edits);
      if (step === Math.floor(plan.steps / 3) || step === plan.steps - 1) goBack(world);
    }
  } finally {
    world.destroy();
  }
}

function goBack(world: World): void {
  const kept = JSON.stringify(world.snapshot());
  const seen = runOf(world);
  for (let i = 1; i <= RESTORES; i++) {
    world.restore(JSON.parse(kept));
    compare(runOf(world), seen, `restore ${i}`);
  }
  const copy = new World();
  for (const _ of copyInto(copy, JSON.parse(kept), world.engine));
  compare(runOf(copy), seen, 'a world made of the snapshot');
  copy.destroy();
  world.restore(JSON.parse(kept));
}

function compare(run: number[][], seen: number[][], what: string): void {
  run.forEach((state, step) => {
    const other = state.findIndex((value, i) => !Object.is(value, seen[step]![i]));
    if (other < 0 && state.length === seen[step]!.length) return;
    throw new Error(
      `${what} is another run after ${step} steps: ${state[other]} is ${seen[step]![other]} in the one that was seen`,
    );
  });
}
