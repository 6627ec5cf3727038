// The chunk `thread`.
import type { threads } from '../nodes/node/threads.js';
import type { World } from '../world/world.js';
import { ask } from './asking.js';
import { Away } from './away.js';
import { boundHere, reportMain, THERE } from './bound.js';
import { Line, workersNow } from './line.js';

export const provide = (): typeof threads.code => ({
  choose: (world) => choose(world as World),
  ask: (world, method, args) => ask(world as World, method, args),
});

/** Bodies from which on `auto` takes a worker: below a hundred most pages have room for the steps themselves. */
const MANY = 100;

function isForWorker({ settings, nodes }: World): boolean {
  const thread = settings.asked<string>('thread');
  if (thread !== 'auto') return thread === 'worker';
  let bodies = 0;
  for (const { type } of nodes) if (type.name === 'RigidBody') bodies++;
  return bodies >= MANY;
}

/** `auto` leaves a core to the page, and each worker one; who asks for a worker has one. */
function hasCore({ settings }: World): boolean {
  const free = Math.max(1, navigator.hardwareConcurrency - 1) - workersNow();
  return free > 0 || settings.asked<string>('thread') === 'worker';
}

function choose(world: World): void {
  if (world.bound === THERE) return;
  const wanted = isForWorker(world);
  world.elsewhere?.begunAnew(wanted);
  if (wanted && !world.elsewhere) leave(world);
}

/** The world goes on there from where it is, and its recording anew, unless something keeps it here. */
function leave(world: World): void {
  const bound = boundHere(world);
  if (bound) return reportMain(world, bound);
  if (!hasCore(world)) return;
  const seconds = world.timeline?.seconds;
  world.timeline?.stop();
  const away = new Away(world, (heard) => {
    const line = new Line(heard);
    void line.call(world.engine.source.workerUrl);
    return line;
  });
  // One that ends meanwhile is recorded no more.
  if (seconds) away.record(seconds).catch(() => {});
}
