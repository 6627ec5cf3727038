import { Clock } from '../../base/clock.js';
import { show } from '../../base/show.js';
import { FRAME } from '../../dynamics/levels.js';
import { frameCosts } from '../../effects/costs/effects.js';
import type { LevelControl } from '../accuracy/level-control.js';
import type { Editing } from '../store/editing.js';
import type { HeapLimit } from '../store/heap-limit.js';
import { PhaseCosts } from './phase-costs.js';
import { Step, type SteppedWorld } from './step.js';
import { StepTime } from './step-time.js';

/**
 * Wall time that the steps of one frame may take, milliseconds; what is left over is dropped and reported. This, and no
 * number of steps, bounds the work of a frame: a world that runs ten times as fast does so while the machine keeps up.
 */
const FRAME_BUDGET = 50;

/** Seconds of the clock dropped before authors are told: the first frames of any page are slow. */
const MUCH_LOST = 1;

/** The world whose time passes. */
export interface TimedWorld extends SteppedWorld {
  readonly edits: Editing;
  readonly control: LevelControl;
  readonly heapLimit: HeapLimit;
}

/** How a world passes time: fixed steps, as many as the clock or the caller asks for. */
export class Stepping {
  readonly #world: TimedWorld;
  readonly #clock = new Clock();
  readonly #costs: PhaseCosts;
  readonly #time = new StepTime();
  readonly #step: Step;
  #paused = false;
  #timeScale = 1;
  /** Seconds of the clock dropped so far. */
  #lost = 0;
  /** Seconds between the present frame and the last one; 0 where nobody waited for it. */
  protected passed = 0;
  /** Whether somebody takes one step after the other, and may speak before each. */
  singly = true;

  constructor(world: TimedWorld) {
    this.#world = world;
    this.#costs = new PhaseCosts(world.registry);
    this.#step = new Step(world, this.#time, this.#costs);
  }

  /** Milliseconds of the last frame. */
  get ms(): PhaseCosts['ms'] {
    return this.#costs.ms;
  }

  /** Seconds of the clock dropped so far. */
  get dropped(): number {
    return this.#lost;
  }

  get paused(): boolean {
    return this.#paused;
  }

  set paused(paused: boolean) {
    this.#paused = paused;
    this.#world.work();
  }

  get timeScale(): number {
    return this.#timeScale;
  }

  set timeScale(scale: number) {
    if (!(scale >= 0 && Number.isFinite(scale))) {
      this.#refuse('timeScale', scale, this.#timeScale, 'timeScale takes a number from 0 on');
      return;
    }
    this.#timeScale = scale;
    this.#world.work();
  }

  #refuse(attribute: string, value: number, used: number, takes: string): void {
    this.#world.report({
      code: 'bad-value',
      severity: 'warning',
      attribute,
      value,
      used,
      message: `${takes}, not ${show(value)}; ${used} is used`,
    });
  }

  // ---- time -------------------------------------------------------------------------------------------------------

  get time(): number {
    return this.#time.at(this.#world.timeStep);
  }

  /** Steps of Bullet so far, whatever became of time. */
  get taken(): number {
    return this.#time.taken;
  }

  /** Seconds that pass before an author has the next word. */
  get turn(): number {
    return this.singly || this.#step.running ? this.#world.timeStep : FRAME;
  }

  /** Steps are about to change their length, seconds. */
  lengthen(from: number, to: number): void {
    this.setTime(this.time);
    if (this.#time.last !== undefined) this.#clock.lengthen(to - from);
  }

  setTime(time: number): void {
    this.#time.set(time);
  }

  /** Goes on from a time, after so many steps: what overlaps now is no beginning. */
  resume(time: number, taken: number): void {
    this.setTime(time);
    this.#time.taken = taken;
    this.#step.begin(false);
  }

  /** A Bullet world was made. */
  restart(): void {
    this.#step.begin(true);
    this.singly = true;
    this.#time.last = undefined;
    this.#clock.reset();
  }

  // ---- steps by hand ----------------------------------------------------------------------------------------------

  step(n: number): number {
    const world = this.#world;
    if (!world.started || this.#step.running) return 0;
    const steps = Number.isFinite(n) ? Math.max(0, Math.floor(n)) : 0;
    if (n === Infinity) this.#refuse('step', n, steps, 'step takes a finite number of steps');
    this.#costs.clear();
    world.flush();
    if (steps > 0) this.singly = steps === 1;
    return this.#stepTimes(steps);
  }

  /** Seconds taken: fewer where a listener ends the world. Added up step by step they would round. */
  #stepTimes(n: number): number {
    let seconds = 0;
    let count = 0;
    let length = 0;
    for (let i = 0; i < n && this.#world.started && !this.#world.awaiting.waits; i++) {
      const taken = this.#step.take();
      if (taken !== length) {
        seconds += count * length;
        count = 0;
        length = taken;
      }
      count++;
    }
    return seconds + count * length;
  }

  // ---- frames -----------------------------------------------------------------------------------------------------

  /**
   * Advances by wall time in fixed steps and places what is drawn between the last two; where nothing is awake, time
   * stands. Returns `needsFrame`. `seen`: somebody waits for the frame, so that accuracy auto is to judge by it.
   */
  frame(seconds: number, seen: boolean): boolean {
    const world = this.#world;
    const looking = world.timeline?.looking;
    if (looking) world.timeline!.frame(seconds * this.#timeScale);
    if (looking || !world.started || this.#step.running) return this.needsFrame;
    const ms = this.#costs.beforeDrawing + this.#costs.ms.write;
    // What steps by hand cost stands until time passes by itself.
    if (this.running) this.#costs.clear();
    world.flush();
    this.singly = false;
    this.passed = seen ? seconds : 0;
    if (seen && this.#moving) world.control.noteFrame(ms, seconds);
    if (this.#moving) this.#run(seconds);
    const fraction = this.#clock.fraction(world.timeStep, this.#time.last);
    world.poses.interpolate(this.#moving ? fraction : 1);
    return this.needsFrame;
  }

  #run(seconds: number): void {
    const scale = this.#timeScale;
    let lost = this.#clock.add(seconds, scale);
    const start = performance.now();
    let first = true;
    while (this.#stepIsDue(first, start)) {
      this.#step.take();
      first = false;
    }
    const left = this.#clock.drop(this.#world.timeStep);
    // Where a listener stopped the world, the rest of the frame is not missed.
    if (this.running) lost += left;
    if (lost > 0) this.#lag(lost, scale);
    this.#world.heapLimit.watch();
  }

  #stepIsDue(first: boolean, start: number): boolean {
    if (!this.running || !(first || performance.now() - start < FRAME_BUDGET)) return false;
    return this.#clock.take(this.#world.timeStep);
  }

  #lag(seconds: number, scale: number): void {
    this.#world.emit('lag', { dropped: seconds, time: this.time });
    this.#lost += seconds / scale;
    if (this.#lost < MUCH_LOST) return;
    this.#world.report({
      code: 'lag',
      severity: 'info',
      used: 'dropped time',
      message:
        'physics or drawing could not keep up with the clock; the time that was lost is dropped',
    });
  }

  /** What was written began at `start` and ends now, and so does the frame; `picture`: milliseconds that drawing it took. */
  frameOver(start: number, picture?: () => number): void {
    this.#costs.ms.write = 0;
    this.#costs.spent('write', start);
    this.#world.registry.caused(frameCosts)?.frameOver(this.ms, this.passed, picture?.());
  }

  /** Whether time passes by itself. */
  get running(): boolean {
    const { started, control, awaiting, timeline } = this.#world;
    return (
      started &&
      !awaiting.waits &&
      !timeline?.looking &&
      control.enabled &&
      !this.#paused &&
      this.#timeScale > 0
    );
  }

  get #moving(): boolean {
    return this.running && this.#world.bodies.goesOn;
  }

  /** While code is on its way, edits wait for that and not for frames. */
  get needsFrame(): boolean {
    const { started, awaiting, edits, timeline } = this.#world;
    if (timeline?.looking) return timeline.playing;
    return started && !awaiting.waits && (this.#moving || edits.pending);
  }
}
