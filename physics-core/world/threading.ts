import { Chunk } from '../base/chunk.js';
import { bulletHas, touchedBy } from './bullet-has.js';
import type { EffectReport } from '../effects/effect/report.js';
import type { PhysicsNode } from '../nodes/node/node.js';
import type { Stats } from './store/types.js';
import type { World } from './world.js';

/** Where the steps of a world are taken. */
export const MAIN = 'main';
export const WORKER = 'worker';
export const THREADS = [MAIN, WORKER, 'auto'] as const;

/** Bodies from which on `auto` takes a worker: below a hundred a page gains nothing by one (measured, 28 bytes a body). */
const MANY = 100;

/** What can be asked of a world on whichever thread it runs. */
export const ASKED = ['advance', 'effects', 'explain', 'raycast', 'snapshot', 'stats', 'step'];

/** A world whose steps are taken on another thread, as it is asked here. */
export interface Elsewhere {
  /** The step that came back last. */
  readonly step: number;
  readonly stats: Stats;
  readonly effects: EffectReport[];
  ask(method: string, args: readonly unknown[]): Promise<unknown>;
  /** Somebody wants to know at once what only the other thread knows. */
  refuse(method: string): null;
  /** What a method did to this world is to be done to the other, too. */
  also(method: string, args: readonly unknown[]): void;
  /** Goes on here from where it is there; settles when it does. */
  comeBack(bound: Bound): Promise<void>;
  /** Bullet's bodies stand here where they stand there. */
  place(): void;
  /** The other thread ends. */
  end(): void;
}

/** Code of its own, in a room above that of worlds. */
interface ThreadCode {
  /** The world goes on there from where it is. */
  leave(world: World): void;
}

export const threads = new Chunk<ThreadCode>({ name: 'thread', causes: '`thread`' });

/** The world that takes a thread. */
export type Threaded = Pick<
  World,
  'started' | 'settings' | 'nodes' | 'heard' | 'report' | 'timeline' | 'elsewhere' | 'bound'
>;

/** Whether a world is to run on another thread. */
function isForWorker({ settings, nodes }: Pick<Threaded, 'settings' | 'nodes'>): boolean {
  const thread = settings.asked<string>('thread');
  if (thread !== 'auto') return thread === WORKER;
  let bodies = 0;
  for (const { type } of nodes) if (type.name === 'RigidBody') bodies++;
  return bodies >= MANY;
}

/** Fetches the code that a world needs to run on another thread, and then calls `start`. False: it needs none. */
export function awaitsThread(world: Threaded, start: () => void): boolean {
  if (threads.here || world.bound || !isForWorker(world)) return false;
  const fail = (error: unknown): void => void (world.bound = { why: String(error) });
  void threads.load().catch(fail).then(start);
  return true;
}

/** A world that begins takes its thread. */
export function takeThread(world: Threaded): void {
  const wanted = isForWorker(world);
  if (!wanted) world.elsewhere?.end();
  if (!wanted || world.elsewhere) return;
  if (awaitsThread(world, () => void (world.started && takeThread(world)))) return;
  const bound = boundHere(world);
  if (bound) reportMain(world, bound);
  else threads.code.leave(world as World);
}

/** Why a world has to run where its page is, and the element that says so. */
export interface Bound {
  why: string;
  host?: unknown;
}

export const GIVEN = 'set_contacts acts in the very next step';

export const BEFORE_STEP: Bound = {
  why: 'beforestep is listened to, and what is done then acts in that very step',
};

function boundHere(world: Threaded): Bound | undefined {
  if (world.heard('beforestep')) return BEFORE_STEP;
  if (world.timeline) return { why: 'it is recorded' };
  for (const node of world.nodes)
    if (node.authored('set_contacts')) return { why: GIVEN, host: node.host };
  return world.bound ?? ('Worker' in globalThis ? undefined : { why: 'there are no workers here' });
}

export function reportMain(world: Threaded, { why, host }: Bound): void {
  world.report(
    {
      code: 'thread-main',
      severity: 'info',
      attribute: 'thread',
      value: world.settings.asked('thread'),
      used: MAIN,
      message: `its steps are taken on the page's own thread, since ${why}`,
    },
    host ?? world.settings,
  );
}

/** What a world that runs here answers. */
export async function answer(
  world: World,
  method: string,
  args: readonly unknown[],
): Promise<unknown> {
  if (method === 'explain') return knownOf(args[0] as PhysicsNode);
  const value = (world as unknown as Record<string, unknown>)[method];
  return typeof value === 'function' ? (value.apply(world, args) as unknown) : value;
}

/** What Bullet has of a node. */
export const knownOf = (
  node: PhysicsNode | undefined,
): { bullet: unknown; touches: PhysicsNode[] | undefined } => ({
  bullet: node && bulletHas(node),
  touches: node && touchedBy(node),
});
