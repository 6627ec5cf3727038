import { Clock } from '../base/clock.js';
import type { Phase } from '../effects/costs/frame-costs.js';
import { show } from '../base/show.js';
import { reportOverlaps } from './overlaps.js';
import type { World } from './world.js';

/**
 * Wall time that the steps of one frame may take, milliseconds; what is left over is dropped and reported. This, and no
 * number of steps, bounds the work of a frame: a world that runs ten times as fast does so while the machine keeps up.
 */
const FRAME_BUDGET = 50;

/** Seconds of the clock dropped before authors are told: the first frames of any page are slow. */
const MUCH_LOST = 1;

/** How a world passes time: fixed steps, as many as the clock or the caller asks for. */
export class Stepping {
  readonly #world: World;
  readonly #clock = new Clock();
  #paused = false;
  #timeScale = 1;
  /** Seconds of the clock dropped so far. */
  #lost = 0;
  /** Steps since the step last changed its length, and the time that was then: sums of steps would round. */
  #steps = 0;
  #timeBefore = 0;
  /** Seconds of the last step. */
  #last: number | undefined;
  #stepping = false;
  /** Steps of Bullet so far, whatever became of time. */
  done = 0;
  /** The next step is the first one: bodies may begin inside each other. */
  #first = true;
  /** Milliseconds of the last frame. */
  readonly ms = { step: 0, read: 0, write: 0, events: 0 };

  constructor(world: World) {
    this.#world = world;
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
      this.#world.report({
        code: 'bad-value',
        severity: 'warning',
        attribute: 'timeScale',
        value: scale,
        used: this.#timeScale,
        message: `timeScale takes a number from 0 on, not ${show(scale)}; ${this.#timeScale} is used`,
      });
      return;
    }
    this.#timeScale = scale;
    this.#world.work();
  }

  // ---- time -----------------------------------------------------------------------------------------------------

  get time(): number {
    return this.#timeBefore + this.#steps * this.#world.timeStep;
  }

  /** Steps are about to change their length, seconds. */
  newTimeStep(from: number, to: number): void {
    this.setTime(this.time);
    if (this.#last !== undefined) this.#clock.lengthen(to - from);
  }

  setTime(time: number): void {
    this.#timeBefore = time;
    this.#steps = 0;
  }

  /** Goes on from a time: what overlaps now is no beginning. */
  resume(time: number): void {
    this.setTime(time);
    this.#first = false;
  }

  /** A Bullet world was made: whatever overlaps in its first step was there before. */
  restart(): void {
    this.#first = true;
    this.#last = undefined;
    this.#clock.reset();
  }

  // ---- steps ----------------------------------------------------------------------------------------------------

  step(n: number): number {
    const world = this.#world;
    if (!world.started || this.#stepping) return 0;
    const steps = Number.isFinite(n) ? Math.max(0, Math.floor(n)) : 0;
    if (n === Infinity) this.#reportSteps(n, steps);
    this.#zeroCosts();
    world.flush();
    return this.#stepTimes(steps);
  }

  /** Seconds taken: fewer where a listener ends the world. Added up step by step they would round. */
  #stepTimes(n: number): number {
    let [seconds, count, length] = [0, 0, 0];
    for (let i = 0; i < n && this.#world.started; i++) {
      const taken = this.#stepOnce();
      if (taken !== length) [seconds, count, length] = [seconds + count * length, 0, taken];
      count++;
    }
    return seconds + count * length;
  }

  #reportSteps(asked: number, used: number): void {
    this.#world.report({
      code: 'bad-value',
      severity: 'warning',
      attribute: 'step',
      value: asked,
      used,
      message: `step takes a finite number of steps, not ${asked}; ${used} are taken`,
    });
  }

  #zeroCosts(): void {
    this.ms.step = this.ms.read = this.ms.events = 0;
  }

  /** A phase of the present frame began at `start` and ends now; milliseconds it took. */
  #spent(phase: Phase, start: number): number {
    const now = performance.now();
    this.ms[phase] += now - start;
    const { timing } = this.#world.registry;
    if (timing.active) timing.measure(phase, start, now);
    return now - start;
  }

  /** What was written began at `start` and ends now, and so does the frame. */
  frameOver(start: number): void {
    this.ms.write = 0;
    this.#spent('write', start);
    this.#world.registry.costs.frameOver(this.ms);
  }

  /** A step and what is told of it; the order stands in event-queue.ts. Seconds it took: none where the world ended. */
  #stepOnce(): number {
    const world = this.#world;
    this.#stepping = true;
    try {
      this.#tell('beforestep');
      if (!world.started) return 0;
      const { bullet } = world;
      const seconds = this.#stepHeld();
      if (world.started && world.bullet === bullet) this.#tell('afterstep');
      return seconds;
    } finally {
      this.#stepping = false;
    }
  }

  /** Meanwhile nobody hears of it. */
  #stepHeld(): number {
    this.#world.events.hold();
    try {
      return this.#stepAwake();
    } finally {
      this.#release();
    }
  }

  #release(): void {
    const { events } = this.#world;
    if (!events.waiting) return events.release();
    const start = performance.now();
    events.release();
    // A listener of something else may have asked for the step.
    events.deliver();
    this.#spent('events', start);
  }

  /** Where nothing is awake, only time goes on. */
  #stepAwake(): number {
    const { bodies, poses } = this.#world;
    this.#world.flush();
    const { timeStep } = this.#world;
    if (bodies.awake > 0 || bodies.countAwake() > 0) {
      poses.shift();
      this.#stepBullet();
    } else this.#steps++;
    return timeStep;
  }

  #stepBullet(): void {
    const start = performance.now();
    const { registry, timeStep, engine, bullet, bodies } = this.#world;
    engine.forgetFound(bullet.bullet);
    registry.beforeStep(timeStep);
    // It writes into the heap, which only a known layout allows.
    engine.contacts.listen(bullet.bullet, engine.heapTrusted ? registry.processor : null);
    bullet.step(timeStep);
    // What is told of the step is told with the time at its end.
    this.#steps++;
    this.done++;
    this.#last = timeStep;
    registry.settle(timeStep);
    this.#world.rays.moved();
    if (this.#first) reportOverlaps(this.#world);
    this.#first = false;
    const stepped = performance.now();
    bodies.read();
    const read = this.#spent('read', stepped);
    registry.afterStep(timeStep);
    this.#spent('step', start);
    // That one lies within it.
    this.ms.step -= read;
  }

  #tell(name: 'beforestep' | 'afterstep'): void {
    const world = this.#world;
    if (!world.heard(name)) return;
    const start = performance.now();
    world.emit(name, { time: this.time, timeStep: world.timeStep });
    world.events.deliver();
    this.#spent('events', start);
  }

  // ---- frames ---------------------------------------------------------------------------------------------------

  frame(seconds: number, seen: boolean): boolean {
    const world = this.#world;
    if (!world.started || this.#stepping) return this.needsFrame;
    const { step, read, events, write } = this.ms;
    // What steps by hand cost stands until time passes by itself.
    if (this.running) this.#zeroCosts();
    world.flush();
    if (seen && this.#moving) world.control.noteFrame(step + read + events + write, seconds);
    if (this.running) this.#run(seconds);
    const fraction = this.#clock.fraction(world.timeStep, this.#last);
    world.poses.interpolate(this.#moving ? fraction : 1);
    return this.needsFrame;
  }

  #run(seconds: number): void {
    const scale = this.#timeScale;
    let lost = this.#clock.add(seconds, scale);
    const start = performance.now();
    let first = true;
    while (this.#stepIsDue(first, start)) {
      this.#stepOnce();
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
      message: 'the simulation could not keep up with the clock; the time it lost is dropped',
    });
  }

  /** Whether time passes by itself. */
  get running(): boolean {
    const { started, enabled } = this.#world;
    return started && enabled && !this.#paused && this.#timeScale > 0;
  }

  get #moving(): boolean {
    return this.running && this.#world.bodies.awake > 0;
  }

  get needsFrame(): boolean {
    return this.#world.started && (this.#moving || this.#world.pending);
  }
}
