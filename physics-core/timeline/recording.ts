import { FRAME } from '../dynamics/levels.js';
import { POSE } from '../dynamics/poses.js';
import type { Drag } from '../effects/drag/drag.js';
import type { Problem } from '../base/problems.js';
import type { Recorder, Run, StepHash, TimelineMark } from '../world/recording.js';
import type { Snapshot } from '../world/snapshot/snapshot.js';
import type { World } from '../world/world.js';
import { callOf } from './calls.js';
import { Deeds } from './deeds.js';
import { reportDiverged } from './diverged.js';
import { hashOf } from './hash.js';
import { History } from './history.js';
import { marksOf } from './marks.js';
import { Twin, type Beginning } from './twin.js';
import { reportWrongTime } from './wrong-time.js';

/** Simulated seconds that are kept, where nobody says how many. */
export const SECONDS = 10;

/** Steps from one hash to the next. */
const HASHED = 60;

/** Simulated seconds from one snapshot to the next: at most so much is run anew to go on from where one looks. */
const APART = 1;

/** Follows a world, keeps what it does for a while, and shows it again. */
export class Recording implements Recorder {
  #world: World;
  /** Simulated seconds that are kept. */
  seconds: number;
  #history = new History();
  #drags = new Map<Drag, number>();
  #dragCount = 0;
  /** The number of the picture that is looked at. */
  #look: number | undefined;
  /** Simulated seconds that are shown, while that plays. */
  #clock: number | undefined;
  #later = new Deeds();
  /** At work of its own, which is not recorded. */
  #busy = false;
  #stops: (() => void)[] = [];

  constructor(world: World, seconds: number) {
    this.#world = world;
    this.seconds = seconds;
  }

  // ---- following --------------------------------------------------------------------------------------------------

  /** Follows the world, from what it is now on. */
  begin(): void {
    this.#history = new History();
    this.#look = this.#clock = undefined;
    this.#later = new Deeds();
    this.#quietly(() => this.#picture(true));
  }

  /** From now on it is the recording of this world. */
  follow(world: World): this {
    this.#letGo();
    this.#world = world;
    world.timeline = world.events.keeper = this;
    const anew = (): void => void (this.#busy || this.begin());
    this.#stops = [
      world.on('reset', anew),
      world.on('restore', anew),
      world.on('accuracy', (change) =>
        this.#levelChanged(change as { level: string; because: string }),
      ),
      world.on('problem', (problem) => this.#told(problem as Problem)),
    ];
    return this;
  }

  #letGo(): void {
    for (const stop of this.#stops) stop();
    this.#stops = [];
    const world = this.#world;
    if (world.timeline === this) world.timeline = world.events.keeper = undefined;
  }

  stop(): void {
    if (this.looking) this.resume();
    this.#letGo();
    this.#world.work();
  }

  #quietly<T>(work: () => T): T {
    const before = this.#busy;
    this.#busy = true;
    try {
      return work();
    } finally {
      this.#busy = before;
    }
  }

  /** Left to itself it is another one now: a twin is told. */
  #levelChanged({ level, because }: { level: string; because: string }): void {
    if (because !== 'asked') this.#note(undefined, undefined, 'level', [level]);
  }

  #told({ message }: Problem): void {
    this.#history.problems.push({ time: this.#world.time, text: message });
  }

  keep<T>(who: object, method: string, args: readonly unknown[], work: () => T): T {
    if (this.#busy || (method === 'flush' && !this.#world.edits.pending)) return work();
    // Whoever takes hold of a body goes on from where he sees it.
    if (this.looking && method === 'drag') this.resume();
    const number = method === 'drag' ? ++this.#dragCount : this.#drags.get(who as Drag);
    if (this.looking) this.#later.putOff({ who, method, args });
    else this.#note(who, number, method, args);
    const result = work();
    if (method === 'drag' && result) this.#drags.set(result as unknown as Drag, number!);
    return result;
  }

  #note(
    who: object | undefined,
    drag: number | undefined,
    method: string,
    args: readonly unknown[],
  ): void {
    const { calls, steps } = this.#history;
    calls.push(callOf(this.#world, who, drag, steps, method, args));
  }

  stepped(): void {
    this.#history.steps++;
    this.#quietly(() => {
      const { time } = this.#world;
      if (this.#history.steps % HASHED === 0)
        this.#history.hashes.push({ step: this.#history.steps, time, hash: hashOf(this.#world) });
      // The step that comes nearest to what is due.
      const now = time + this.#world.timeStep / 2;
      if (now - this.to < FRAME) return;
      this.#picture(now - this.#history.beginnings.at(-1)!.snapshot.time >= APART);
      this.#history.forget(time - this.seconds);
    });
  }

  #picture(whole: boolean): void {
    const world = this.#world;
    if (whole) this.#history.beginnings.push(this.#beginning());
    const moment = { step: this.#history.steps, time: world.time, whole };
    this.#history.pictures.add(moment, [...world.bodies], world.poses);
  }

  #beginning(): Beginning {
    for (const drag of this.#drags.keys()) if (!drag.held) this.#drags.delete(drag);
    return {
      step: this.#history.steps,
      snapshot: this.#world.snapshot(),
      drags: [...this.#drags].map(([{ body, point }, drag]) => ({ drag, body: body.id, point })),
    };
  }

  // ---- looking ----------------------------------------------------------------------------------------------------

  get from(): number {
    return this.#history.from;
  }

  get to(): number {
    return this.#history.to;
  }

  get at(): number | undefined {
    return this.#look === undefined ? undefined : this.#history.pictures.at(this.#look).time;
  }

  get looking(): boolean {
    return this.#look !== undefined;
  }

  get playing(): boolean {
    return this.#clock !== undefined;
  }

  get hashes(): readonly StepHash[] {
    return this.#history.hashes;
  }

  get marks(): TimelineMark[] {
    const done = marksOf(this.#world, this.#history.calls, this.#history.pictures);
    return [...done, ...this.#history.problems].sort((one, other) => one.time - other.time);
  }

  seek(time: number): void {
    if (!Number.isFinite(time)) return reportWrongTime(this.#world, time);
    this.#clock = undefined;
    this.#leave();
    this.#show(this.#history.pictures.nearest(time));
  }

  /** The last picture is that of the running world. */
  #leave(): void {
    if (this.looking) return;
    this.#world.flush();
    const { pictures, steps } = this.#history;
    if (pictures.at(pictures.length - 1).step < steps) this.#quietly(() => this.#picture(false));
  }

  #show(look: number): void {
    this.#look = look;
    const { poses, bodies } = this.#world;
    const slots = new Map([...bodies].map(({ id, slot }) => [id, slot]));
    this.#history.pictures.show(look, (id, pose) => {
      const slot = slots.get(id);
      if (slot === undefined) return;
      poses.current.set(pose, slot * POSE);
      poses.snap(slot);
    });
    this.#world.work();
  }

  play(): void {
    this.#leave();
    const { at } = this;
    this.#clock = at === undefined || at >= this.to ? this.from : at;
    this.#show(this.#history.pictures.nearest(this.#clock));
  }

  pause(): void {
    this.#clock = undefined;
  }

  frame(seconds: number): void {
    if (this.#clock !== undefined) {
      this.#clock += seconds;
      this.#show(this.#history.pictures.nearest(this.#clock));
      if (this.#clock >= this.to) this.#clock = undefined;
    }
    this.#world.poses.interpolate(1);
  }

  // ---- going on ---------------------------------------------------------------------------------------------------

  resume(): void {
    if (this.#look === undefined) return;
    const look = this.#look;
    this.#look = this.#clock = undefined;
    this.#quietly(() => this.#goTo(look));
    this.#later.do();
    this.#world.work();
  }

  /** The world at the end of a step, run anew, with what was done to it since where nothing came later. */
  #snapshotAt(look: number): Snapshot {
    const history = this.#history;
    const { step, time } = history.pictures.at(look);
    const twin = new Twin(history.calls);
    try {
      for (const _ of twin.begin(this.#world, history.before(step)));
      for (const _ of twin.runTo(step));
      if (!this.#isShown(look, twin.world)) reportDiverged(this.#world, step, time);
      if (step === history.steps) twin.redo();
      return twin.world.snapshot();
    } finally {
      twin.world.destroy();
    }
  }

  #goTo(look: number): void {
    this.#world.restore(this.#snapshotAt(look));
    this.#history.cut(this.#history.pictures.at(look).step);
  }

  /** Whether all bodies are where a picture has them. */
  #isShown(look: number, { bodies, poses }: World): boolean {
    const slots = new Map([...bodies].map(({ id, slot }) => [id, slot]));
    let same = true;
    this.#history.pictures.show(look, (id, pose) => {
      const at = POSE * (slots.get(id) ?? 0);
      if (slots.has(id))
        same &&= pose.every((value, i) => value === Math.fround(poses.current[at + i]!));
    });
    return same;
  }

  snapshot(): Snapshot {
    return this.#quietly(() => this.#snapshotAt(this.#look!));
  }

  exportRun(): Run {
    return this.#history.export();
  }
}
