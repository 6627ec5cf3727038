// The chunk `timeline`.
import { show } from '../base/show.js';
import type { RecordOptions, Timeline, recordings } from '../world/recording.js';
import { dense } from '../world/snapshot/dense.js';
import type { World } from '../world/world.js';
import { importRun } from './import-run.js';
import { Recording, SECONDS } from './recording.js';

export const provide = (): typeof recordings.code => ({ record, begin, importRun });

/** Its snapshots are dense. Where its steps are taken it is kept. */
async function record(world: World, { seconds = SECONDS }: RecordOptions): Promise<Timeline> {
  await dense.load();
  const kept = accepted(world, seconds);
  return world.elsewhere ? world.elsewhere.record(kept) : begin(world, kept);
}

function begin(world: World, seconds: number): Timeline {
  world.timeline?.stop();
  world.flush();
  const recording = new Recording(world, seconds).follow(world);
  recording.begin();
  return recording;
}

function accepted(world: World, seconds: number): number {
  if (seconds > 0) return seconds;
  world.report({
    code: 'bad-value',
    severity: 'warning',
    attribute: 'record',
    value: seconds,
    used: SECONDS,
    message: `record keeps a number of seconds above 0, not ${show(seconds)}; ${SECONDS} is used`,
  });
  return SECONDS;
}
