import { PhysicsNode } from '../nodes/node/node.js';
import type { Problem, ProblemReport } from '../base/problems.js';
import { seeContacts } from '../effects/debug/contact-marks.js';
import { particles } from '../effects/particles/effects.js';
import { deformables } from '../effects/deformables/effects.js';
import { ropes } from '../effects/soft/effects.js';
import { waves } from '../effects/water/effects.js';
import type { Engine } from '../engine/engine.js';
import { Redoing } from '../timeline/calls.js';
import { copyInto } from '../world/snapshot/copy.js';
import { recordings, type StepHash } from '../world/recording.js';
import type { Snapshot } from '../world/snapshot/snapshot.js';
import { World } from '../world/world.js';
import { answer as answerHere } from './asking.js';
import {
  PLAIN,
  type Answer,
  type Deed,
  type EffectCosts,
  type Listening,
  type Look,
  type Order,
  type Recorded,
  type Said,
} from './messages.js';
import { THERE } from './bound.js';
import { Moved } from './moved.js';
import { tell } from './words.js';

/** What both worlds know of is told by the page's; only this one knows how much memory it has. */
const OWN = ['heap-low', 'heap-exhausted', 'edit-failed'];

/** A world that does what another is asked for, takes its steps, and says what comes of it. */
export class OtherSide extends World {
  #said: Said[] = [];
  readonly #redoing = new Redoing(this);
  readonly #moved = new Moved();
  readonly #stops = new Map<string, () => void>();
  /** Problems that the page knows of from here. */
  readonly #told = new WeakSet<Problem>();
  /** The last hash that was told. */
  #hash: StepHash | undefined;
  /** While it does what the page's world did, which tells of that itself. */
  #quiet = false;

  constructor(snapshot: Snapshot, engine: Engine) {
    super();
    for (const _ of copyInto(this, snapshot, engine));
    this.registry.find(particles)?.tellAnew();
    // What overlaps in the first step of all overlapped before.
    if (snapshot.taken === 0) this.stepping.restart();
    this.on('problem', (problem) => this.#tellProblem(problem as Problem));
    this.on('lag', (detail) => this.#say({ node: undefined, event: 'lag', detail }));
    this.on('accuracy', (detail) => {
      if ((detail as { because: string }).because !== 'asked')
        this.#say({ node: undefined, event: 'accuracy', detail });
    });
  }

  #say(said: Said): void {
    this.#said.push(said);
  }

  #tellProblem(problem: Problem): void {
    if (this.#quiet && !OWN.includes(problem.code)) return;
    this.#told.add(problem);
    const { element, ...report } = problem;
    const value = tell(problem.value);
    this.#say({ node: numberOf(element), problem: { ...report, value } satisfies ProblemReport });
  }

  /** It is where it was to be. */
  override bound = THERE;

  override settle(about: unknown, attribute?: string, code?: string): void {
    const known = this.problemsOf(about).some(
      (each) =>
        (!attribute || each.attribute === attribute) &&
        (!code || each.code === code) &&
        this.#told.has(each),
    );
    super.settle(about, attribute, code);
    if (known) this.#say({ node: numberOf(about), settled: { attribute, code } });
  }

  take(order: Order): Answer {
    this.paused = order.paused;
    this.timeScale = order.timeScale;
    this.#quietly(() => {
      for (const deed of order.deeds) this.#do(deed);
      this.flush();
    });
    for (const { seconds, seen } of order.stretches) this.#pass(seconds, seen);
    // Where somebody looks back no time passes: what he sees is drawn, too.
    if (order.stretches.length === 0) this.#pass(0, false);
    const asked = order.ask && this.#answer(order.ask);
    const said = this.#said;
    this.#said = [];
    return {
      number: order.number,
      ...this.#moved.write(this, order.rooms?.states),
      clouds: this.#clouds(order.rooms?.clouds),
      surfaces: this.registry.find(waves)?.tell(),
      ropes: this.registry.find(ropes)?.tell(),
      deformables: this.registry.find(deformables)?.tell(),
      fraction: this.poses.fraction,
      time: this.time,
      taken: this.stepsTaken,
      stopped: this.paused && !order.paused,
      needsFrame: this.stepping.needsFrame,
      said,
      stats: this.stats,
      contacts: order.marked ? seeContacts(this) : undefined,
      effects: order.watched ? this.#costs() : undefined,
      recorded: this.#recorded(order.remembered),
      asked,
    };
  }

  /** Without particles there is nothing to tell. */
  #clouds(room = new Float64Array(1)): Float64Array<ArrayBuffer> {
    room[0] = 0;
    return this.registry.find(particles)?.tell(room) ?? room;
  }

  #quietly(work: () => void): void {
    this.#quiet = true;
    try {
      work();
    } finally {
      this.#quiet = false;
    }
  }

  #do(deed: Deed): void {
    if ('call' in deed) this.#redoing.do(deed.call);
    else if ('restore' in deed) this.restore(deed.restore);
    else if ('look' in deed) this.#look(deed.look);
    else this.#listen(deed.listening);
  }

  #look({ method, args }: Look): void {
    this.timeline?.[method](args[0]!);
  }

  #recorded(remembered: boolean): Recorded | undefined {
    const { timeline } = this;
    if (!timeline) return undefined;
    const { from, to, at, playing, hashes } = timeline;
    const last = hashes.at(-1);
    const others = last !== this.#hash;
    this.#hash = last;
    return {
      ...{ from, to, at, playing },
      hashes: others ? hashes : undefined,
      marks: remembered ? timeline.marks : undefined,
    };
  }

  #listen({ node: id, event, heard }: Listening): void {
    const key = `${id} ${event}`;
    this.#stops.get(key)?.();
    this.#stops.delete(key);
    const who = id === undefined ? this : this.node(id);
    if (heard && who)
      this.#stops.set(
        key,
        who.on(event, (detail) => this.#say({ node: id, event, detail: tell(detail) })),
      );
  }

  #pass(seconds: number, seen: boolean): void {
    this.frame(seconds, seen);
    this.#moved.note(this);
  }

  #answer({ method, args }: NonNullable<Order['ask']>): unknown {
    const answered = this.#answered(method, this.#redoing.decoded(args));
    // What steps by hand moved is drawn, too.
    this.#pass(0, false);
    return PLAIN.includes(method) ? answered : tell(answered);
  }

  #answered(method: string, args: readonly unknown[]): unknown {
    if (method === 'record') return void recordings.code.begin(this, args[0] as number);
    if (method !== 'resume') return answerHere(this, method, args);
    this.resume();
    return this.snapshot();
  }

  #costs(): EffectCosts {
    const entries = this.effects.map(({ name, active, ms, calls }) => [
      name,
      { active, ms, calls },
    ]);
    return Object.fromEntries(entries) as EffectCosts;
  }
}

const numberOf = (about: unknown): number | undefined =>
  about instanceof PhysicsNode ? about.id : undefined;
