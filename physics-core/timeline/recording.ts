import { hypot } from '../base/exact/index.js';
import { FRAME, levelNames, levels, type LevelName } from '../dynamics/levels.js';
import { POSE } from '../dynamics/poses.js';
import { debugging } from '../effects/debug/debugging.js';
import { particles } from '../effects/particles/effects.js';
import type { Hold } from '../effects/drag/hold.js';
import type { Problem } from '../base/problems.js';
import type { Recorder, Run, StepHash, TimelineMark } from '../world/recording.js';
import type { Watching } from '../world/measuring.js';
import type { Snapshot } from '../world/snapshot/snapshot.js';
import type { World } from '../world/world.js';
import { callOf } from './calls.js';
import { Deeds } from './deeds.js';
import { reportDiverged } from './diverged.js';
import { Ghost } from './ghost.js';
import { hashOf } from './hash.js';
import { History } from './history.js';
import { marksOf } from './marks.js';
import { A_TIME, refuse } from './refuse.js';
import { Twin, type Beginning } from './twin.js';

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
  #drags = new Map<Hold, number>();
  #dragCount = 0;
  /** The number of the picture that is looked at. */
  #look: number | undefined;
  /** Simulated seconds that are shown, while that plays. */
  #clock: number | undefined;
  #later = new Deeds();
  #ghost: Ghost | undefined;
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
    this.#ghost?.cut(-1);
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
    this.#ghost = undefined;
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
    const number = method === 'drag' ? ++this.#dragCount : this.#drags.get(who as Hold);
    if (this.looking) this.#later.putOff({ who, method, args });
    else this.#note(who, number, method, args);
    const result = work();
    if (method === 'drag' && result) this.#drags.set(result as unknown as Hold, number!);
    return result;
  }

  #note(
    who: object | undefined,
    drag: number | undefined,
    method: string,
    args: readonly unknown[],
  ): void {
    const { calls, steps } = this.#history;
    const { time, timeStep } = this.#world;
    calls.push({ ...callOf(this.#world, who, drag, steps, method, args), time, timeStep });
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
    this.#history.pictures.add(moment, [...world.bodies], world.poses.current);
    this.#history.clouds.add(moment.step, world);
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
    if (!Number.isFinite(time)) return refuse(this.#world, 'seek', A_TIME, time);
    this.#clock = undefined;
    this.#lookAt(time);
  }

  #lookAt(time: number): void {
    const { looking } = this;
    if (!looking) this.#pictureEnd();
    this.#show(this.#history.pictures.nearest(time));
    if (!looking) this.#raiseGhost();
  }

  /** The last picture is that of the running world. */
  #pictureEnd(): void {
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
    this.#history.clouds.show(this.#history.pictures.at(look).step, this.#world);
    this.#world.work();
  }

  play(): void {
    const { at = Infinity } = this;
    this.#clock = at < this.to ? at : this.from;
    this.#lookAt(this.#clock);
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

  // ---- the same at another level ----------------------------------------------------------------------------------

  async ghost(name?: LevelName, watching: Watching = {}): Promise<void> {
    const level = levels.find((one) => one.name === name);
    if (name !== undefined && !level)
      return refuse(this.#world, 'ghost', `one of ${levelNames.join(', ')}`, name);
    watching.signal?.throwIfAborted();
    if (!this.looking) this.#pictureEnd();
    const ghost = level && new Ghost(this.#history, level);
    this.#ghost = ghost;
    this.#drawGhost();
    if (!ghost) return;
    const isWanted = (): boolean => this.#ghost === ghost && this.#world.timeline === this;
    try {
      await ghost.run(this.#world, watching, isWanted);
    } catch (error) {
      if (isWanted()) this.#ghost = undefined;
      throw error;
    }
    if (isWanted()) this.#drawGhost();
  }

  get ghostLevel(): LevelName | undefined {
    return this.#ghost?.level.name;
  }

  get apart(): number | undefined {
    let most = 0;
    const there = this.eachGhost((_, [x, y, z], own) => {
      most = Math.max(most, hypot(x! - own[0]!, y! - own[1]!, z! - own[2]!));
    });
    return there ? most : undefined;
  }

  eachGhost(put: (id: number, pose: Float32Array, own: Float32Array) => void): boolean {
    if (this.#look === undefined || !this.#ghost) return false;
    const { pictures } = this.#history;
    const own = new Map<number, Float32Array>();
    pictures.show(this.#look, (id, pose) => own.set(id, pose));
    // Pictures may still show what is gone.
    const seen = new Set([...this.#world.bodies].map(({ id }) => id));
    return this.#ghost.show(pictures.at(this.#look).step, (id, pose) => {
      if (seen.has(id) && own.has(id)) put(id, pose, own.get(id)!);
    });
  }

  /** Somebody begins to look: what came since it was run is to be run, too. */
  #raiseGhost(): void {
    const { level, end } = this.#ghost ?? {};
    if (level && end! < this.#history.steps) void this.ghost(level.name);
    else this.#drawGhost();
  }

  /** It is drawn because of the bodies that have one, while somebody looks. */
  #drawGhost(): void {
    const { registry, bodies } = this.#world;
    for (const body of bodies)
      if (this.looking && this.#ghost?.whole && body.movable)
        registry.get(debugging).need(body, 'its ghost in the timeline');
      else registry.find(debugging)?.release(body);
    this.#world.work();
  }

  // ---- going on ---------------------------------------------------------------------------------------------------

  resume(): void {
    if (this.#look === undefined) return;
    const look = this.#look;
    this.#look = this.#clock = undefined;
    this.#quietly(() => this.#goTo(look));
    this.#world.registry.find(particles)?.lookBack(undefined);
    this.#drawGhost();
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
    const { step } = this.#history.pictures.at(look);
    this.#history.cut(step);
    this.#ghost?.cut(step);
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
