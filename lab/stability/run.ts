import { createWorld } from '../../physics-core/create.js';
import { type LevelName, type World } from '../../physics-core/inside.js';
import { bitsOf } from './bits.js';
import type { Cell, Play, StabilityCase } from './case.js';
import { CommonWatch } from './watch.js';

const FRAME = 1 / 60;

/** Lets the author speak and time pass, until it is over or something breaks. */
function play(world: World, which: StabilityCase, { before, pass }: Play, watch: CommonWatch) {
  const seconds = which.steps ? which.steps * world.timeStep : which.seconds;
  const ticks = Math.round(seconds / FRAME);
  for (let i = 0; i < ticks && !watch.why; i++) {
    before?.(i * FRAME, i);
    if (pass) pass();
    else world.advance(FRAME);
  }
}

function judge(which: StabilityCase, measured: number, why: string | undefined): Cell {
  const holds = !why && measured <= which.criterion.most;
  return { holds, measured, ...(why && { why }) };
}

/** One cell of the matrix. `begun` is told of its world while that is empty. */
export async function runCell(
  which: StabilityCase,
  level: LevelName,
  begun?: (world: World) => void,
): Promise<Cell> {
  const world = await createWorld({
    console: false,
    rest: 'never',
    accuracy: level,
    ...which.world,
  });
  begun?.(world);
  const { now } = performance;
  // Steps are counted, not milliseconds: a busy machine makes no frame drop any.
  performance.now = () => 0;
  try {
    const played = which.scene(world);
    world.step(0);
    const watch = new CommonWatch(world, which);
    world.on('afterstep', () => {
      watch.look();
      played.after?.();
    });
    play(world, which, played, watch);
    watch.end();
    const noted = played.noted?.();
    const cell = judge(which, played.measured(), watch.why);
    return { ...cell, bits: bitsOf(world), ...(noted && { noted }) };
  } catch (error) {
    return judge(which, NaN, `throws: ${String(error)}`);
  } finally {
    performance.now = now;
    world.destroy();
  }
}
