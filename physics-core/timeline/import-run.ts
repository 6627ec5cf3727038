import { levels } from '../dynamics/levels.js';
import { inSlices } from '../accuracy/slices.js';
import { RUN_FORMAT, type Run, type Timeline } from '../world/recording.js';
import type { Watching } from '../world/measuring.js';
import { faultOf } from '../world/snapshot/check.js';
import { loadNode } from '../world/snapshot/load.js';
import { Lookup } from '../world/snapshot/lookup.js';
import { goneIn } from '../world/snapshot/restore.js';
import type { World } from '../world/world.js';
import { isCall } from './calls.js';
import { reportDiverged } from './diverged.js';
import { Recording, SECONDS } from './recording.js';
import { twinOf } from './twin.js';

/** Steps that an imported run may have: an hour at the finest level. */
const MOST_STEPS = 3600 / levels.at(-1)!.timeStep;

/** Runs a run anew beside a world, which then is where that ended. */
export async function importRun(
  world: World,
  run: Run,
  watching: Watching,
): Promise<Timeline | undefined> {
  const fault = faultIn(run);
  if (fault) return refuse(world, fault, run);
  if ([...world.bodies].length === 0) bear(world, run);
  const foreign = faultOf(run.start, world.nodes, world.bullet.kept);
  if (foreign) return refuse(world, foreign, run);
  const { recording, twin } = await inSlices(replay(world, run), watching);
  world.recorder?.stop();
  world.restore(twin.snapshot());
  recording.follow(world);
  // All of it stays until more has come.
  recording.seconds = Math.max(SECONDS, recording.to - recording.from);
  twin.destroy();
  world.work();
  return recording;
}

/** Ends where its hashes are others. */
function* replay(
  world: World,
  { start, drags, calls, steps, hashes }: Run,
): Generator<number, { recording: Recording; twin: World }> {
  const recording = new Recording(world, Infinity);
  let twin!: World;
  const work = twinOf(world, { step: 0, snapshot: start, drags }, calls, steps, (born) => {
    twin = born;
    recording.follow(born).begin();
  });
  const then = new Map(hashes.map(({ step, hash }) => [step, hash]));
  for (let next = work.next(); !next.done; next = work.next()) {
    const { step, time, hash } = recording.hashes.at(-1) ?? NONE;
    if ((then.get(step) ?? hash) !== hash) {
      reportDiverged(world, step, time);
      break;
    }
    yield next.value;
  }
  return { recording, twin };
}

const NONE = { step: -1, time: 0, hash: '' };

/** An empty world gets the nodes of the run. */
function bear(world: World, { start }: Run): void {
  const born = new Map([...world.nodes].map((node) => [node.id, node]));
  for (const { id, type, name, version, collection } of start.nodes) {
    const group = collection === undefined ? undefined : born.get(collection);
    if (!born.has(id)) born.set(id, world.add(type, {}, { id, name, version, collection: group }));
  }
  const found = new Lookup(world.nodes, start, goneIn(world));
  for (const node of [...world.nodes]) loadNode(node, found);
}

function faultIn(run: unknown): string | undefined {
  const { x3dPhysicsRun, steps, calls, hashes, drags, start } = (run ?? {}) as Partial<Run>;
  if (x3dPhysicsRun === undefined) return 'importRun takes what exportRun() gave';
  if (x3dPhysicsRun !== RUN_FORMAT) return 'this run is of another version of x3d-physics';
  const whole =
    Number.isInteger(steps) &&
    steps! <= MOST_STEPS &&
    [calls, hashes, drags].every(Array.isArray) &&
    calls!.every(isCall) &&
    typeof start === 'object';
  return whole
    ? undefined
    : 'parts of this run are missing, or are no numbers, or it is longer than an hour';
}

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
