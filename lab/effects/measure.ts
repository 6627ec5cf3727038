import { loadEngine } from '../../physics-core/create.js';
import { World } from '../../physics-core/inside.js';
import { allEffects } from '../../physics-core/effects/all.js';
import type { EffectDescriptor } from '../../physics-core/effects/effect/effect.js';
import { estimate, median, type Estimate } from '../statistics.js';
import type { Addition } from './additions.js';
import { build, type Scene } from './scenes.js';

/** Pairs of turns, and steps of each turn. */
export const PAIRS = 25;
export const TURN = 20;
/** Steps before anything is measured, for the compiler and for what has to come to lie. */
const WARM_UP = 100;

/** What an effect adds to a step, and how it was found. */
export interface EffectCost {
  effect: string;
  by: string;
  /** What else came on with it. */
  along: string[];
  /** Milliseconds of a step without it: a median. */
  without: number;
  /** Milliseconds that it adds to a step: of pairs of turns. */
  ms: Estimate;
  /** Calls of its hooks in a step. */
  calls: number;
  /** The chunk that its code comes in; null: it comes with every page. */
  chunk: string | null;
}

/** Milliseconds at work so far, not by the clock: what else the machine does is not to count. */
function worked(): number {
  const { user, system } = process.cpuUsage();
  return (user + system) / 1000;
}

async function started(scene: Scene) {
  const world = new World();
  world.add('RigidBodyCollection', { rest: 'never', ...scene.world });
  const begin = build(world, scene);
  world.start(await loadEngine());
  world.step(0);
  if (world.problems.length > 0) throw new Error(world.problems[0]!.message);
  const before = await begin();
  const step = (): void => {
    before();
    world.step();
  };
  for (let i = 0; i < WARM_UP; i++) step();
  return { world, step };
}

/** Milliseconds of one step. */
function timeOf(step: () => void): number {
  const start = worked();
  for (let i = 0; i < TURN; i++) step();
  return (worked() - start) / TURN;
}

const callsOf = (world: World, effect: EffectDescriptor): number =>
  world.registry.find(effect)?.cost.calls ?? 0;

/** Those that are on, or were within the last steps. */
const used = (world: World): EffectDescriptor[] =>
  allEffects.filter((each) => world.registry.active(each) || callsOf(world, each) > 0);

export async function costOf(addition: Addition): Promise<EffectCost> {
  const [less, more] = [await started(addition.without), await started(addition.with)];
  const pairs = Array.from({ length: PAIRS }, (_, i) => {
    // Neither is always the first.
    const [first, second] = i % 2 ? [more, less] : [less, more];
    const [a, b] = [timeOf(first.step), timeOf(second.step)];
    return i % 2 ? { less: b, more: a } : { less: a, more: b };
  });
  const before = used(less.world);
  const after = used(more.world);
  const itself = after.find(({ name }) => name === addition.effect);
  if (!itself) throw new Error(`${addition.by} does not bring ${addition.effect}`);
  const along = after.filter((each) => each !== itself && !before.includes(each));
  const calls = callsOf(more.world, itself);
  less.world.destroy();
  more.world.destroy();
  return {
    effect: addition.effect,
    by: addition.by,
    along: along.map(({ name }) => name),
    without: median(pairs.map((pair) => pair.less)),
    ms: estimate(pairs.map((pair) => pair.more - pair.less)),
    calls,
    chunk: itself.chunk?.name ?? null,
  };
}
