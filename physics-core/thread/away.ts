import { levelNamed } from '../dynamics/levels.js';
import { debugging } from '../effects/debug/debugging.js';
import type { Hold } from '../effects/drag/hold.js';
import type { CollisionEnd } from '../effects/contacts/touches.js';
import type { EffectReport } from '../effects/effect/report.js';
import type { CollidableNode } from '../nodes/collision/collidable.js';
import type { ContactNode } from '../nodes/collision/contact-node.js';
import { CollisionSensorNode } from '../nodes/collision/collision-sensor-node.js';
import { PhysicsNode } from '../nodes/node/node.js';
import { callOf, encode } from '../timeline/calls.js';
import { Deeds } from '../timeline/deeds.js';
import type { AccuracyChange } from '../world/accuracy/level-control.js';
import type { Run, Timeline } from '../world/recording.js';
import { becomeAs } from '../world/snapshot/restore.js';
import type { Snapshot } from '../world/snapshot/snapshot.js';
import { takeSnapshot } from '../world/snapshot/take.js';
import { statsOf } from '../world/stats.js';
import type { Stepping } from '../world/stepping/stepping.js';
import type { Stats } from '../world/store/types.js';
import type { Bound, Elsewhere } from '../world/threading.js';
import type { World } from '../world/world.js';
import { Begun } from './begun.js';
import { BEFORE_STEP, reportMain, whyHere } from './bound.js';
import type { Heard, Line } from './line.js';
import {
  PLAIN,
  type Answer,
  type Deed,
  type EffectCosts,
  type Look,
  type Order,
  type Rooms,
  type Said,
} from './messages.js';
import { Mirror } from './mirror.js';
import { RemoteRecording } from './remote-recording.js';
import { RemoteStepping } from './remote-stepping.js';
import { hear } from './words.js';

/** What is always told: it can be read here. */
const ALWAYS: Record<string, readonly string[]> = {
  CollisionSensor: ['isActive', 'intersections'],
  ParticleSystem: ['isActive'],
};

/** What sensors tell on from when it was first asked for: contacts are many. */
const ONCE_ASKED = 'contacts';

const NONE = new Float64Array(0);

/** Somebody who waits for an answer. */
interface Waiting {
  number: number;
  method: string;
  args: readonly unknown[];
  resolve(value: unknown): void;
  reject(error: unknown): void;
}

const LOST = 'the worker of this world is lost';

/** They go on from where somebody looks. */
const OF_TIME = ['advance', 'step'];

/** What only this world asks. */
const OF_OURS = ['record', 'resume'];

/** Of the world's own events, those that come about where it runs. */
const OF_STEPS = ['afterstep'];

/** A world of the page whose steps are taken on another thread: what is done to it is done there, what comes of it is shown here. */
export class Away implements Elsewhere {
  readonly #world: World;
  readonly #here: Stepping;
  readonly #there: RemoteStepping;
  readonly #mirror: Mirror;
  readonly #line: Line;
  #deeds: Deed[] = [];
  readonly #drags = new WeakMap<object, number>();
  #drag = 0;
  #nodes = new Map<number, PhysicsNode>();
  /** Orders that were given, the last one that was answered, and the one from which on answers count. */
  #given = 0;
  #answered = 0;
  #since = 0;
  readonly #waiting: Waiting[] = [];
  #last: Answer | undefined;
  #rooms: Rooms | undefined;
  #costs: EffectCosts = {};
  #watched = false;
  #marked = false;
  #coming: Promise<void> | undefined;
  readonly #later = new Deeds();
  readonly #begun = new Begun();
  #recording: RemoteRecording | undefined;
  #lost = false;
  #passing = false;

  /** `open` makes the way to the other thread. */
  constructor(world: World, open: (heard: Heard) => Line) {
    this.#world = world;
    this.#mirror = new Mirror(world);
    this.#here = world.stepping;
    this.#there = new RemoteStepping(world, this);
    this.#line = open(this);
    this.#begin();
    world.stepping = this.#there;
    world.events.keeper = this;
    world.events.silent = true;
    world.elsewhere = this;
  }

  #begin(): void {
    const world = this.#world;
    // The other world listens for this one, to what it is told.
    this.#line.say({
      snapshot: { ...takeSnapshot(world), heard: [] },
      program: world.engine.source.program,
    });
    for (const node of world.nodes) this.#introduce(node);
    for (const event of OF_STEPS) this.listened(world, event);
  }

  #introduce(node: PhysicsNode): void {
    const always = ALWAYS[node.type.name] ?? [];
    const begins = node.heard('collisionend') ? ['collisionstart'] : [];
    for (const event of new Set([...always, ...begins, ...node.heardEvents]))
      this.#listen(node.id, event, true);
  }

  // ---- what is done here ------------------------------------------------------------------------------------------

  keep<T>(who: object, method: string, args: readonly unknown[], work: () => T): T {
    if (method === 'flush') {
      const { pending } = this.#world.edits;
      if (pending || !this.#passing) this.place();
      if (!pending) return work();
    }
    if (this.#lost) return work();
    const why = whyHere(args[0]);
    if (why) this.#world.stay({ why, host: (who as PhysicsNode).host });
    const recording = this.#recording;
    if (this.#world.elsewhere !== this || recording?.again) return work();
    if (method === 'drag') recording?.resume();
    // He would hold what is about to be put where it was.
    if (method === 'drag' && recording?.resuming) return undefined as T;
    if (this.#coming) this.#later.putOff({ who, method, args });
    recording?.done({ who, method, args });
    const number = method === 'drag' ? ++this.#drag : this.#drags.get(who);
    const deed = { call: callOf(this.#world, who, number, 0, method, args) };
    this.#deeds.push(deed);
    const result = this.#done(deed, work);
    if (method === 'drag' && result) this.#drags.set(result as unknown as Hold, number!);
    if (result instanceof PhysicsNode) this.#introduce(result);
    this.#there.done();
    return result;
  }

  /** What throws is not done there either. */
  #done<T>(deed: Deed, work: () => T): T {
    try {
      return work();
    } catch (error) {
      this.#deeds = this.#deeds.filter((each) => each !== deed);
      throw error;
    }
  }

  listened(who: object, event: string): void {
    const world = this.#world;
    if (who === world) {
      if (event === 'beforestep' && world.heard(event)) void this.comeBack(BEFORE_STEP);
      if (OF_STEPS.includes(event)) this.#listen(undefined, event, world.heard(event));
    } else {
      const node = who as PhysicsNode;
      const always =
        ALWAYS[node.type.name]?.includes(event) ||
        (node instanceof CollisionSensorNode && event === ONCE_ASKED);
      this.#listen(node.id, event, always || node.heard(event));
      // Who is told of an end has to be told of it by this world, too, if it goes on here or ends.
      if (event === 'collisionend')
        this.#listen(node.id, 'collisionstart', node.heard(event) || node.heard('collisionstart'));
    }
  }

  #listen(node: number | undefined, event: string, heard: boolean): void {
    if (!this.#lost) this.#deeds.push({ listening: { node, event, heard } });
  }

  begunAnew(goesOn: boolean): void {
    if (this.#lost || !goesOn) {
      this.end('reset');
      return this.#recordHere();
    }
    this.#deeds.push({ call: callOf(this.#world, undefined, undefined, 0, 'reset', []) });
    this.#recording?.leave();
    this.#forget();
  }

  restored(snapshot: Snapshot): void {
    this.#deeds.push({ restore: snapshot });
    this.#recording?.leave();
    this.#forget();
  }

  /** What is answered to earlier orders is of the past. */
  #forget(): void {
    this.#since = this.#given + 1;
    this.#there.done();
  }

  place(): void {
    this.#mirror.place();
  }

  /** Time passes: nobody reads anything. */
  flush(): void {
    this.#passing = true;
    try {
      this.#world.flush();
    } finally {
      this.#passing = false;
    }
  }

  // ---- orders -----------------------------------------------------------------------------------------------------

  get waits(): boolean {
    return !this.#lost && this.#answered < this.#given;
  }

  get due(): boolean {
    return !this.#lost && (this.#deeds.length > 0 || this.#given === 0);
  }

  get begins(): boolean {
    return this.#given > 0 && this.#answered === 0;
  }

  /** One at a time: the next one waits for the answer. */
  send(): void {
    if (this.#lost || this.#coming || this.#answered < this.#given) return;
    this.#order(undefined);
  }

  #order(ask: Order['ask']): number {
    const rooms = this.#rooms;
    this.#rooms = undefined;
    this.#note();
    const order: Order = {
      number: ++this.#given,
      deeds: this.#deeds,
      ...this.#there.news(),
      watched: this.#watched,
      marked: this.#marked,
      remembered: this.#recording?.remembered ?? false,
      ask,
      rooms,
    };
    this.#deeds = [];
    this.#line.say(order, rooms ? [rooms.states.buffer, rooms.clouds.buffer] : []);
    return this.#given;
  }

  /** What was done here since the last order is told by the next one. */
  #note(): void {
    if (this.due) this.#mirror.note(this.next);
  }

  ask(method: string, args: readonly unknown[]): Promise<unknown> {
    if (this.#lost) return Promise.reject(new Error(LOST));
    if (this.#coming) return this.#coming.then(() => this.#world.ask(method, ...args));
    if (OF_TIME.includes(method)) this.#recording?.resume();
    if (method === 'step') this.#there.singly = args[0] === undefined || args[0] === 1;
    return new Promise((resolve, reject) => this.#request({ method, args, resolve, reject })).then(
      (value) => this.#exported(method, value),
    );
  }

  #exported(method: string, value: unknown): unknown {
    if (method !== 'exportRun' || !value) return value;
    return this.#recording?.exported(value as Run) ?? value;
  }

  #request(of: Omit<Waiting, 'number'>): void {
    this.#world.flush();
    const number = this.#order({ method: of.method, args: of.args.map(encode) });
    this.#waiting.push({ number, ...of });
  }

  refuse(method: string): null {
    this.#world.report({
      code: 'asynchronous',
      severity: 'warning',
      attribute: method,
      used: 'nothing',
      message: `${method} can’t be answered at once by a world that runs in a worker; await world.ask('${method}') can`,
    });
    return null;
  }

  // ---- what is recorded --------------------------------------------------------------------------------------------

  async record(seconds: number): Promise<Timeline> {
    if (this.#lost) throw new Error(LOST);
    if (this.#coming) {
      await this.#coming;
      return this.#world.record({ seconds });
    }
    await new Promise((resolve, reject) =>
      this.#request({ method: 'record', args: [seconds], resolve, reject }),
    );
    // Where there is no worker it is recorded here.
    if (this.#world.elsewhere !== this) return this.#world.record({ seconds });
    const recording = new RemoteRecording(this.#world, this, seconds);
    if (this.#last) recording.take(this.#last);
    return (this.#world.timeline = this.#recording = recording);
  }

  get next(): number {
    return this.#given + 1;
  }

  /** Somebody waits to see it: it does not wait for the next frame, and what was done before is done before. */
  look(look: Look): void {
    this.flush();
    this.#deeds.push({ look });
    this.send();
    this.#world.work();
  }

  goOn(resolve: (snapshot: unknown) => void): void {
    this.#request({ method: 'resume', args: [], resolve, reject: () => {} });
  }

  /** What it was is kept no more; what is to come is. */
  #recordHere(): void {
    const recording = this.#recording;
    if (!recording || this.#world.timeline !== recording) return;
    this.#world.timeline = undefined;
    void this.#world.record({ seconds: recording.seconds });
  }

  // ---- answers ----------------------------------------------------------------------------------------------------

  answered(answer: Answer): void {
    const { number, states, clouds, asked } = answer;
    this.#answered = number;
    this.#rooms = { states, clouds };
    if (number >= this.#since) this.#show(answer);
    this.#settle(number, ({ method, resolve }) =>
      resolve(PLAIN.includes(method) ? asked : this.#heard(asked)),
    );
    this.#world.work();
  }

  #settle(number: number, how: (one: Waiting) => void): void {
    while (this.#waiting[0] && this.#waiting[0].number <= number) how(this.#waiting.shift()!);
  }

  #show(answer: Answer): void {
    const stepped = answer.taken !== this.step;
    this.#last = answer;
    this.#costs = answer.effects ?? this.#costs;
    this.#note();
    this.#mirror.take(answer, stepped);
    this.#there.take(answer);
    this.#recording?.take(answer);
    if (this.#world.registry.active(debugging)) this.place();
    const { events } = this.#world;
    events.during(() => {
      for (const said of answer.said) this.#tell(said);
    });
  }

  #tell(said: Said): void {
    const world = this.#world;
    const node = said.node === undefined ? undefined : this.#node(said.node);
    if (said.node !== undefined && !node) return;
    if ('problem' in said) world.report(said.problem, node ?? world);
    else if ('settled' in said)
      world.settle(node ?? world, said.settled.attribute, said.settled.code);
    else if (node) this.#tellOf(node, said.event, this.#heard(said.detail));
    else if (said.event === 'accuracy') this.#goTo(said.detail as AccuracyChange);
    else world.emit(said.event, said.detail);
  }

  /** It is told when all that came with it is shown. */
  #tellOf(node: PhysicsNode, event: string, detail: unknown): void {
    if (node instanceof CollisionSensorNode) {
      if (event === 'isActive') node.show(detail as boolean, undefined);
      if (event === 'intersections') node.show(undefined, detail as CollidableNode[]);
      if (event === ONCE_ASKED) node.showContacts(detail as ContactNode[]);
    }
    const { events } = this.#world;
    if (node.toldElsewhere?.(event, detail) === false) return;
    events.silent = false;
    node.emit(event, detail);
    events.silent = true;
    this.#begun.note(node, event, detail);
  }

  #goTo({ level, because, p90 }: AccuracyChange): void {
    if (because !== 'asked')
      this.#world.control.obey({ level: levelNamed(level), because, p90: p90 ?? 0 });
  }

  #heard(value: unknown): unknown {
    return hear(value, this.#world, (id) => this.#node(id));
  }

  /** Also one that was removed here meanwhile. */
  #node(id: number): PhysicsNode | undefined {
    if (!this.#nodes.has(id)) {
      const now = [...this.#world.nodes].map((node) => [node.id, node] as const);
      this.#nodes = new Map(this.#nodes.size > 2 * now.length ? now : [...this.#nodes, ...now]);
    }
    return this.#nodes.get(id);
  }

  get step(): number {
    return this.#last?.taken ?? 0;
  }

  get stats(): Stats {
    const here = statsOf(this.#world, this.#there);
    const { created, patched, destroyed, ms } = here;
    return this.#last ? { ...this.#last.stats, created, patched, destroyed, ms } : here;
  }

  get effects(): EffectReport[] {
    this.#watched = true;
    return this.#world.registry.report().map((one) => ({ ...one, ...this.#costs[one.name] }));
  }

  get contacts(): Float64Array {
    this.#marked = true;
    return this.#last?.contacts ?? NONE;
  }

  // ---- the end ----------------------------------------------------------------------------------------------------

  comeBack(bound: Bound): Promise<void> {
    if (this.#lost) return Promise.resolve();
    if (!this.#coming) reportMain(this.#world, bound);
    this.#coming ??= new Promise((done) => {
      const land = (snapshot?: unknown): void => {
        this.#land(snapshot as Snapshot | undefined);
        done();
      };
      // Where there is none to come, that was told.
      this.#request({ method: 'snapshot', args: [], resolve: land, reject: () => land() });
    });
    return this.#coming;
  }

  /** Goes on from there. */
  #land(snapshot: Snapshot | undefined): void {
    if (!snapshot || this.#world.elsewhere !== this) return;
    const isNow = this.#given >= this.#since;
    const { events } = this.#world;
    this.#leave();
    events.during(() => {
      events.silent = true;
      if (isNow) becomeAs(this.#world, snapshot);
      events.silent = false;
    });
    this.#later.do();
    this.#recordHere();
    this.#world.work();
  }

  /** Nobody is there: all that was done was done here, no time has passed, and what was asked is answered here. */
  missing(error: unknown): void {
    const world = this.#world;
    const why = error instanceof Error ? error.message : String(error);
    world.bound = { why: `no worker can be had (${why})` };
    reportMain(world, world.bound);
    this.#leave();
    for (const { method, args, resolve } of this.#waiting.splice(0))
      resolve(OF_OURS.includes(method) ? undefined : world.ask(method, ...args));
    world.work();
  }

  lost(error: unknown): void {
    this.#lost = true;
    this.#world.timeline = this.#recording = undefined;
    this.#there.stand();
    const message = `the worker of this world is lost (${String(error)}); it stands still until it is reset`;
    this.#world.report(
      { code: 'thread-lost', severity: 'error', value: String(error), used: 'nothing', message },
      this.#world.settings,
    );
    for (const { reject } of this.#waiting.splice(0)) reject(new Error(message));
  }

  end(reason: CollisionEnd = 'removed'): void {
    const { time } = this.#there;
    this.#leave();
    this.#begun.end(reason, time);
    for (const { reject } of this.#waiting.splice(0)) reject(new Error('the world has ended'));
  }

  #leave(): void {
    const world = this.#world;
    this.#line.close();
    this.#mirror.end();
    if (world.elsewhere !== this) return;
    const { paused, timeScale, time } = this.#there;
    world.stepping = this.#here;
    world.events.keeper = world.elsewhere = undefined;
    world.events.silent = false;
    this.#here.restart();
    this.#here.setTime(time);
    this.#here.paused = paused;
    this.#here.timeScale = timeScale;
  }
}
