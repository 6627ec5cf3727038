import { Clock } from '../clock.js';
import type { Phase } from '../effects/costs.js';
import { show } from '../show.js';
import { reportOverlaps } from './overlaps.js';
import type { World } from './world.js';

/** Wall time that the steps of one frame may take, milliseconds; what is left over is dropped and reported. */
const FRAME_BUDGET = 50;

/** Seconds dropped before authors are told: the first frames of any page are slow. */
const MUCH_LOST = 1;

/** How a world passes time: fixed steps, as many as the clock or the caller asks for. */
export class Stepping {
  readonly #world: World;
  readonly #clock = new Clock();
  #paused = false;
  #timeScale = 1;
  /** Seconds dropped so far. */
  #lost = 0;
  /** Steps since the step last changed its length, and the time that was then: sums of steps would round. */
  #steps = 0;
  #timeBefore = 0;
  /** Seconds of the last step. */
  #last: number | undefined;
  #stepping = false;
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
    for (let i = 0; i < steps && world.started; i++) this.#stepOnce();
    return steps * world.timeStep;
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

  #stepOnce(): void {
    this.#stepping = true;
    try {
      this.#event('beforestep');
      if (this.#world.started) this.#stepAwake();
      this.#event('afterstep');
    } finally {
      this.#stepping = false;
    }
  }

  /** Where nothing is awake, only time goes on. */
  #stepAwake(): void {
    const { bodies, poses } = this.#world;
    this.#world.flush();
    if (bodies.awake > 0 || bodies.countAwake() > 0) {
      poses.shift();
      this.#stepBullet();
    } else this.#steps++;
  }

  #stepBullet(): void {
    const start = performance.now();
    const { registry, timeStep, engine, bullet, bodies } = this.#world;
    engine.forgetFound(bullet.bullet);
    registry.beforeStep(timeStep);
    // A listener may have reset the world: this step is none of the new one's.
    if (this.#world.bullet !== bullet) return;
    // It writes into the heap, which only a known layout allows.
    engine.contacts.listen(bullet.bullet, engine.heapTrusted ? registry.processor : null);
    bullet.step(timeStep);
    // What is told of the step is told with the time at its end; a listener may reset it.
    this.#steps++;
    this.#last = timeStep;
    registry.settle(timeStep);
    this.#world.rays.moved();
    if (this.#first) reportOverlaps(this.#world);
    this.#first = false;
    const stepped = performance.now();
    bodies.read();
    const read = this.#spent('read', stepped);
    if (this.#world.bullet === bullet) registry.afterStep(timeStep);
    this.#spent('step', start);
    // That one lies within it.
    this.ms.step -= read;
  }

  #event(name: 'beforestep' | 'afterstep'): void {
    const world = this.#world;
    if (!world.heard(name)) return;
    const start = performance.now();
    world.emit(name, { time: this.time, timeStep: world.timeStep });
    this.#spent('events', start);
  }

  // ---- frames ---------------------------------------------------------------------------------------------------

  frame(seconds: number, seen: boolean): boolean {
    const world = this.#world;
    if (!world.started) return false;
    const { step, read, events, write } = this.ms;
    // What steps by hand cost stands until time passes by itself.
    if (this.running) this.#zeroCosts();
    world.flush();
    if (seen && this.#moving) world.control.noteFrame(step + read + events + write, seconds);
    if (this.running) this.#run(seconds * this.#timeScale);
    const fraction = this.#clock.fraction(world.timeStep, this.#last);
    world.poses.interpolate(this.#moving ? fraction : 1);
    return this.needsFrame;
  }

  #run(seconds: number): void {
    const { timeStep } = this.#world;
    const { steps, dropped } = this.#clock.advance(seconds, timeStep);
    const start = performance.now();
    let done = 0;
    while (done < steps && (done === 0 || performance.now() - start < FRAME_BUDGET)) {
      this.#stepOnce();
      done++;
    }
    const lost = dropped + (steps - done) * timeStep;
    if (lost > 0) this.#lag(lost);
    this.#world.heapLimit.watch();
  }

  #lag(seconds: number): void {
    this.#world.emit('lag', { dropped: seconds, time: this.time });
    this.#lost += seconds;
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
