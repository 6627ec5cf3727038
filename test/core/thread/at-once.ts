import { World } from '../../../physics-core/inside.js';
import { Away } from '../../../physics-core/thread/away.js';
import type { Recorder } from '../../../physics-core/world/recording.js';
import type { Bound } from '../../../physics-core/world/threading.js';
import { Line, type Port } from '../../../physics-core/thread/line.js';
import type { Beginning, Message, Order } from '../../../physics-core/thread/messages.js';
import { OtherSide } from '../../../physics-core/thread/other-side.js';
import { hear } from '../../../physics-core/thread/words.js';

// A world whose steps are taken on the other side, by a twin that answers before a line of a test goes on: so facts that are
// told of a world of this thread are told of one of another thread as well.

/** The other side, and what was said to it and not yet heard. */
class Twin implements Port {
  onmessage: Port['onmessage'] = null;
  readonly #world: World;
  #said: (Beginning | Order)[] = [];
  there: OtherSide | undefined;
  #ended = false;
  asked: unknown;

  constructor(world: World) {
    this.#world = world;
  }

  postMessage(message: unknown, transfer: Transferable[]): void {
    this.#said.push(structuredClone(message, { transfer }) as Beginning | Order);
    queueMicrotask(() => this.hear());
  }

  /** Hears what was said, and answers. */
  hear(): void {
    for (let message = this.#said.shift(); message; message = this.#said.shift())
      if ('snapshot' in message) this.there = new OtherSide(message.snapshot, this.#world.engine);
      else if (!this.#ended) this.#answer(message);
  }

  #answer(order: Order): void {
    const answer = this.there!.take(order);
    const data: Message = { answer: structuredClone(answer) };
    this.asked = data.answer.asked;
    this.onmessage!({ data } as MessageEvent<Message>);
  }

  end(): void {
    this.#ended = true;
    this.there?.destroy();
  }
}

/** It stays away when its world begins anew, though nothing says so. */
class Staying extends Away {
  override begunAnew(): void {
    super.begunAnew(true);
  }

  override comeBack(bound: Bound): Promise<void> {
    const back = super.comeBack(bound);
    this.onwords?.();
    return back;
  }

  onwords?: () => void;
}

const twins = new WeakMap<World, Twin>();

/** The world that takes its steps: itself, where nobody else does. */
export function steppingOf(world: World): World {
  const twin = twins.get(world);
  if (!twin || !world.elsewhere) return world;
  void world.elsewhere.ask('stats', []);
  twin.hear();
  return twin.there!;
}

/** From now on its steps are taken there; what it is asked is answered at once. */
export function goAwayAtOnce(world: World): void {
  const twin = new Twin(world);
  twins.set(world, twin);
  const away = new Staying(world, (heard) => {
    const line = new Line(heard);
    line.speak(twin, () => twin.end());
    return line;
  });
  away.onwords = () => twin.hear();
  // They come with answers from when they are first asked for.
  void world.effects;
  void away.contacts;
  const here = {
    step: world.step,
    raycast: world.raycast,
    snapshot: world.snapshot,
    frame: world.frame,
    reset: world.reset,
    restore: world.restore,
  };
  type Method = keyof typeof here;
  /** Facts read of Bullet, too. */
  const hearAndPlace = (): void => {
    twin.hear();
    world.elsewhere?.place();
  };
  const call = (method: Method, ...args: unknown[]) =>
    (here[method] as (...args: unknown[]) => unknown).apply(world, args);
  const ask = (method: Method, ...args: unknown[]) => {
    if (!world.elsewhere) return call(method, ...args);
    void world.elsewhere.ask(method, args).catch(() => undefined);
    hearAndPlace();
    return method === 'snapshot' ? twin.asked : hear(twin.asked, world, (id) => world.node(id));
  };
  /** Answers come at once. */
  const then = (method: Method, ...args: unknown[]) => {
    const value = call(method, ...args);
    answerAtOnce();
    return value;
  };
  const answerAtOnce = (): void => {
    if (world.elsewhere) void world.elsewhere.ask('stats', []).catch(() => undefined);
    hearAndPlace();
  };
  Object.assign(world, {
    step: (n = 1) => stepSingly(world, n, () => ask('step') as number) ?? ask('step', n),
    raycast: (...way: unknown[]) => ask('raycast', ...way),
    snapshot: () => ask('snapshot'),
    frame: (...time: unknown[]) => then('frame', ...time),
    reset: () => then('reset'),
    restore: (snapshot: unknown) => then('restore', snapshot),
    exportRun: () => structuredClone(World.prototype.exportRun.call(steppingOf(world))),
  });
  const { record } = world;
  world.record = async (options) => {
    const timeline = await record.call(world, options);
    const { seek, play, pause, stop, resume } = timeline as Recorder;
    const looks = { seek, play, pause, stop, resume };
    for (const [name, look] of Object.entries(looks))
      Object.assign(timeline, {
        [name]: (...args: [number]) => {
          look.apply(timeline as Recorder, args);
          answerAtOnce();
        },
      });
    return timeline;
  };
}

/** Many steps by hand: who hears of one may speak before the next. */
function stepSingly(world: World, n: number, step: () => number): number | undefined {
  const heard =
    world.heard('afterstep') || [...world.nodes].some((node) => node.heardEvents.length > 0);
  if (!Number.isInteger(n) || n < 2 || !world.elsewhere || !heard) return undefined;
  // By their length, which a listener may change: added up one by one they would round.
  const taken = new Map<number, number>();
  for (let i = 0; i < n && world.started; i++) {
    const seconds = step();
    taken.set(seconds, (taken.get(seconds) ?? 0) + 1);
  }
  return [...taken].reduce((sum, [seconds, count]) => sum + count * seconds, 0);
}
