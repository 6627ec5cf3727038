import { Deeds } from '../timeline/deeds.js';
import { A_TIME, refuse } from '../timeline/refuse.js';
import type { LevelName } from '../dynamics/levels.js';
import type { Recorder, Run, StepHash, TimelineMark } from '../world/recording.js';
import { restoreSnapshot } from '../world/snapshot/restore.js';
import type { Snapshot } from '../world/snapshot/snapshot.js';
import type { World } from '../world/world.js';
import type { Answer, Look } from './messages.js';

/** What carries to the other thread what somebody looks at. */
interface Courier {
  /** The number of the next order. */
  readonly next: number;
  look(look: Look): void;
  /** The world goes on from where somebody looks; it is told what it is then. */
  goOn(resolve: (snapshot: unknown) => void): void;
  refuse(method: string): null;
}

/** What is recorded on another thread, as it is shown here. */
export class RemoteRecording implements Recorder {
  readonly #world: World;
  readonly #courier: Courier;
  readonly seconds: number;
  from = 0;
  to = 0;
  at: number | undefined = undefined;
  playing = false;
  hashes: readonly StepHash[] = [];
  #marks: readonly TimelineMark[] = [];
  /** Somebody has read the marks since they came. */
  #read = false;
  /** The order from which on answers know where one looks. */
  #since = 0;
  /** One that was asked for. */
  #run: Run | undefined;
  /** It is about to go on from where somebody looked. */
  resuming = false;
  /** What was done there in its turn is done here again. */
  again = false;
  readonly #later = new Deeds();

  constructor(world: World, courier: Courier, seconds: number) {
    this.#world = world;
    this.#courier = courier;
    this.seconds = seconds;
  }

  take({ number, recorded }: Answer): void {
    if (!recorded) return;
    this.from = recorded.from;
    this.to = recorded.to;
    this.hashes = recorded.hashes ?? this.hashes;
    this.#marks = recorded.marks ?? this.#marks;
    if (number < this.#since) return;
    this.at = recorded.at;
    this.playing = recorded.playing;
  }

  /** Those of the answer that follows when they are read: they may be many. */
  get marks(): readonly TimelineMark[] {
    this.#read = true;
    return this.#marks;
  }

  /** Whether the next answer is to bring them. */
  get remembered(): boolean {
    const read = this.#read;
    this.#read = false;
    return read;
  }

  get looking(): boolean {
    return this.at !== undefined;
  }

  seek(time: number): void {
    if (!Number.isFinite(time)) return refuse(this.#world, 'seek', A_TIME, time);
    this.#look('seek', Math.min(Math.max(time, this.from), this.to), false, [time]);
  }

  play(): void {
    const { at = this.to } = this;
    this.#look('play', at >= this.to ? this.from : at, true);
  }

  pause(): void {
    this.#look('pause', this.at, false);
  }

  /** Shown at once, until there is an answer. */
  #look(
    method: Look['method'],
    at: number | undefined,
    playing: boolean,
    args: number[] = [],
  ): void {
    this.at = at;
    this.playing = playing;
    this.#since = this.#courier.next;
    this.#courier.look({ method, args });
  }

  stop(): void {
    this.resume();
    this.#courier.look({ method: 'stop', args: [] });
    this.#world.timeline = undefined;
  }

  resume(): void {
    if (!this.looking) return;
    this.leave();
    this.resuming = true;
    this.#courier.goOn((snapshot) => this.#resumed(snapshot as Snapshot | undefined));
  }

  /** Somebody did something. */
  done(deed: Parameters<Deeds['putOff']>[0]): void {
    if (this.resuming) this.#later.putOff(deed);
  }

  #resumed(snapshot: Snapshot | undefined): void {
    this.resuming = false;
    if (!snapshot) return;
    this.again = true;
    try {
      this.#world.events.anew(() => restoreSnapshot(this.#world, snapshot));
      this.#later.do();
    } finally {
      this.again = false;
    }
    this.#world.work();
  }

  /** Nobody looks back any more. */
  leave(): void {
    this.at = undefined;
    this.playing = false;
    this.#since = this.#courier.next;
  }

  /** What `world.ask('exportRun')` is told goes by here, for what worlds of a page add to it. */
  exported(run: Run): Run {
    this.#run = run;
    const exported = this.#world.exportRun()!;
    this.#run = undefined;
    return exported;
  }

  exportRun(): Run {
    return this.#run ?? (this.#courier.refuse('exportRun') as unknown as Run);
  }

  snapshot(): Snapshot {
    return this.#courier.refuse('snapshot') as unknown as Snapshot;
  }

  /** Its bodies would have to come with each answer. */
  ghost(level?: LevelName): Promise<void> {
    if (level)
      this.#world.report({
        code: 'asynchronous',
        severity: 'warning',
        attribute: 'ghost',
        value: level,
        used: 'nothing',
        message:
          "there is no ghost of what a worker recorded; world.importRun(await world.ask('exportRun')) has it here, with ghosts",
      });
    return Promise.resolve();
  }

  readonly ghostLevel = undefined;
  readonly apart = undefined;

  eachGhost(): boolean {
    return false;
  }

  // Steps are taken and followed there.

  keep<T>(_: object, __: string, ___: readonly unknown[], work: () => T): T {
    return work();
  }

  stepped(): void {}

  frame(): void {}
}
