import { inSlices } from '../accuracy/slices.js';
import { levels } from '../dynamics/levels.js';
import { RUN_FORMAT, type Run, type Timeline } from '../world/recording.js';
import type { Watching } from '../world/measuring.js';
import { dense } from '../world/snapshot/dense.js';
import { faultOf as faultIn } from '../world/snapshot/check.js';
import { loadNode } from '../world/snapshot/load.js';
import { Lookup } from '../world/snapshot/lookup.js';
import type { Snapshot } from '../world/snapshot/snapshot.js';
import { nodesOf, statesIn } from '../world/snapshot/states.js';
import { goneIn } from '../world/snapshot/restore.js';
import type { World } from '../world/world.js';
import { isCall } from './calls.js';
import { reportDiverged } from './diverged.js';
import { Recording, SECONDS } from './recording.js';
import { Twin } from './twin.js';

/** Steps that an imported run may have: an hour at the finest level. */
const MOST_STEPS = 3600 / levels.at(-1)!.timeStep;

/** Runs a run anew beside a world, which then is where that ended. */
export async function importRun(
  world: World,
  run: Run,
  watching: Watching,
): Promise<Timeline | undefined> {
  await dense.load();
  await world.elsewhere?.comeBack({ why: 'a run is imported' });
  const fault = faultOf(world, run);
  if (fault) return refuse(world, fault, run);
  const twin = new Twin(run.calls);
  try {
    if (isEmpty(world)) bear(world, run);
    const recording = await inSlices(replay(world, twin, run), watching);
    world.timeline?.stop();
    world.restore(twin.world.snapshot());
    // All of it stays until more has come.
    recording.seconds = Math.max(SECONDS, recording.to - recording.from);
    return recording.follow(world);
  } catch (error) {
    watching.signal?.throwIfAborted();
    return refuse(world, `this run can’t be run: ${String(error)}`, run);
  } finally {
    twin.world.destroy();
  }
}

/** Ends where its hashes are others. */
function* replay(world: World, twin: Twin, run: Run): Generator<number, Recording> {
  yield* twin.begin(world, { step: 0, snapshot: run.start, drags: run.drags });
  const recording = new Recording(twin.world, Infinity).follow(twin.world);
  recording.begin();
  const then = new Map(run.hashes.map(({ step, hash }) => [step, hash]));
  for (const done of twin.runTo(run.steps)) {
    const { step, time, hash } = recording.hashes.at(-1) ?? NONE;
    if ((then.get(step) ?? hash) === hash) yield done;
    else {
      reportDiverged(world, step, time);
      return recording;
    }
  }
  twin.redo();
  return recording;
}

const NONE = { step: -1, time: 0, hash: '' };

/** An empty world gets the nodes of the run. */
function bear(world: World, { start }: Run): void {
  const born = new Map([...world.nodes].map((node) => [node.id, node]));
  for (const { id, type, name, version, collection } of statesIn(start)) {
    const group = collection === undefined ? undefined : born.get(collection);
    if (!born.has(id)) born.set(id, world.add(type, {}, { id, name, version, collection: group }));
  }
  const found = new Lookup(world.nodes, start, goneIn(world));
  for (const node of [...world.nodes]) loadNode(node, found);
}

/** What is wrong with a run, for people; undefined: nothing. */
function faultOf(world: World, run: unknown): string | undefined {
  const { x3dPhysicsRun, steps, calls, hashes, drags, start } = (run ?? {}) as Partial<Run>;
  if (x3dPhysicsRun === undefined) return 'importRun takes what exportRun() gave';
  if (x3dPhysicsRun !== RUN_FORMAT) return 'this run is of another version of x3d-physics';
  if (steps! > MOST_STEPS) return 'this run is longer than an hour';
  const whole =
    Number.isInteger(steps) &&
    [calls, hashes, drags].every(areRecords) &&
    calls!.every(isCall) &&
    Array.isArray(start?.nodes);
  if (!whole) return 'parts of this run are missing, or are no numbers';
  if (isEmpty(world)) return faultIn(start, undefined, world.bullet.kept);
  const fault = faultIn(start, nodesOf(world), world.bullet.kept);
  return fault ?? (isOf(world, start!) ? undefined : 'this run is of another scene');
}

/** Whether all that was there then is here, by the same numbers and names. */
function isOf({ nodes }: World, start: Snapshot): boolean {
  const named = (type: string, name: string | undefined) => `${type} ${name ?? ''}`;
  const here = new Map([...nodes].map(({ id, type, name }) => [id, named(type.name, name)]));
  return statesIn(start).every(({ id, type, name }) => here.get(id) === named(type, name));
}

const isEmpty = ({ bodies }: World): boolean => [...bodies].length === 0;

const areRecords = (all: unknown): boolean =>
  Array.isArray(all) && all.every((one) => typeof one === 'object' && one !== null);

function refuse(world: World, fault: string, value: unknown): undefined {
  world.report({
    code: 'bad-value',
    severity: 'warning',
    attribute: 'importRun',
    value,
    used: 'nothing',
    message: `${fault}; nothing is run`,
  });
}
