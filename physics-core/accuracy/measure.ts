import { show } from '../base/show.js';
import type { LevelMeasurement, Measured, MeasureOptions } from '../world/measuring.js';
import type { Snapshot } from '../world/snapshot/snapshot.js';
import type { World } from '../world/world.js';
import { inWorker } from './in-worker.js';
import { leftOutOf } from './left-out.js';
import { levelNames, type LevelName } from '../dynamics/levels.js';
import { Measurement, type Job } from './measurement.js';
import { inSlices } from './slices.js';

const SECONDS = 2;
const LONGEST = 60;

/** Runs a world's scene anew, from a snapshot of it, at each level. The world itself notices nothing of it. */
export async function measureAccuracy(
  world: World,
  snapshot: Snapshot,
  { seconds = SECONDS, levels = levelNames, ...watching }: MeasureOptions,
): Promise<LevelMeasurement[]> {
  const { engine } = world;
  watching.signal?.throwIfAborted();
  const job: Job = {
    snapshot,
    levels: levelNames.filter((name) => accepted(world, levels).includes(name)),
    seconds: length(world, seconds),
  };
  const leftOut = leftOutOf(world);
  const { program, workerUrl } = engine.source;
  const there = await inWorker({ job, program }, workerUrl, watching);
  const measured = there ?? (await inSlices(here(job, await engine.another()), watching));
  return measured.map((row) => ({
    ...row,
    worst: row.worst === undefined ? undefined : world.node(row.worst)?.host,
    inWorker: there !== undefined,
    leftOut,
  }));
}

const here = (job: Job, engine: World['engine']): Generator<number, Measured[]> =>
  new Measurement(job, engine).run();

/** Names that are levels; all levels where none is. */
function accepted(world: World, names: readonly LevelName[]): readonly LevelName[] {
  const known = levelNames.filter((name) => names.includes(name));
  if (known.length === names.length && known.length > 0) return known;
  const used = known.length > 0 ? known : levelNames;
  refuse(world, 'levels', names, used);
  return used;
}

function length(world: World, seconds: number): number {
  if (seconds > 0 && seconds <= LONGEST) return seconds;
  refuse(world, 'seconds', seconds, SECONDS);
  return SECONDS;
}

function refuse(world: World, attribute: string, value: unknown, used: unknown): void {
  world.report({
    code: 'bad-value',
    severity: 'warning',
    attribute,
    value,
    used,
    message: `measureAccuracy: ${attribute} ${show(value)} is not possible; ${show(used)} is used`,
  });
}
