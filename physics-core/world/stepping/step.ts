import type { LevelName } from '../../dynamics/levels.js';
import { contacts, type HardContacts } from '../../effects/effect/chunks.js';
import type { SolverListener } from '../../engine/solver-hook.js';
import type { NodeWorld } from '../../nodes/node/node-world.js';
import type { BodySlots } from '../bodies/body-slots.js';
import type { Awaiting } from '../store/awaiting.js';
import type { PhaseCosts } from './phase-costs.js';
import type { StepRecorder } from './step-recorder.js';
import type { StepTime } from './step-time.js';

/** The world that a step goes through. */
export interface SteppedWorld extends NodeWorld {
  readonly bodies: BodySlots;
  readonly awaiting: Awaiting;
  readonly timeline: StepRecorder | undefined;
  readonly accuracy: LevelName;
  readonly control: {
    /** Splits the step that begins into parts, as many as are asked for or more; returns how many. */
    split(parts: number): number;
  };
  heard(event: string): boolean;
}

/** One step, from what is told before it to what is told after it. */
export class Step {
  readonly #world: SteppedWorld;
  readonly #time: StepTime;
  readonly #costs: PhaseCosts;
  /** Listeners of a step may ask for another: there is none in it. */
  running = false;
  #hardContacts: HardContacts | undefined;
  /** The next step is the first one: bodies may begin inside each other. */
  #first = true;
  /** `beforestep` was told of a step that has to wait. */
  #begun = false;

  constructor(world: SteppedWorld, time: StepTime, costs: PhaseCosts) {
    this.#world = world;
    this.#time = time;
    this.#costs = costs;
  }

  /** A Bullet world was made: whatever overlaps in its first step was there before. `first` FALSE: it goes on from a time. */
  begin(first: boolean): void {
    this.#first = first;
    this.#begun = false;
    this.#hardContacts?.forget();
  }

  /**
   * The road of a step, stage by stage. Returns the seconds it took: none where a listener ended the world, or made an edit
   * that needs code which is not here; that acts in this very step, which goes on once it is.
   */
  take(): number {
    const world = this.#world;
    // Whoever steps while looking back goes on from there.
    if (world.timeline?.looking) world.timeline.resume();
    this.running = true;
    try {
      if (!this.#begun) this.#tell('beforestep');
      if (!world.started) return 0;
      const { bullet } = world;
      this.#hold();
      const seconds = this.#simulate();
      this.#begun = seconds === 0;
      if (seconds > 0 && world.started && world.bullet === bullet) this.#tell('afterstep');
      return seconds;
    } finally {
      this.running = false;
    }
  }

  /** Meanwhile nobody hears of anything; what a step brings about is told when it is over. */
  #simulate(): number {
    const world = this.#world;
    try {
      world.flush();
      if (world.awaiting.waits) return 0;
      const { timeStep, bodies } = world;
      if (bodies.goesOn) this.#move(timeStep);
      else this.#time.pass();
      world.timeline?.stepped();
      return timeStep;
    } finally {
      this.#release();
    }
  }

  #move(timeStep: number): void {
    const start = performance.now();
    const { poses, control, registry: effects } = this.#world;
    poses.shift();
    const parts = control.split(effects.parts(timeStep));
    let read = 0;
    for (let i = 0; i < parts; i++) read += this.#takePart(parts);
    effects.stepOver(timeStep);
    this.#costs.spent('step', start);
    // That one lies within it.
    this.#costs.ms.step -= read;
  }

  /** One of so many steps of Bullet. Returns the milliseconds that reading took. */
  #takePart(parts: number): number {
    const { registry: effects, partOfStep } = this.#world;
    effects.run('beforeStep', partOfStep);
    this.#stepBullet(partOfStep, parts);
    effects.run('settle', partOfStep);
    this.#world.rays.moved();
    this.#reportContacts();
    const read = this.#read();
    effects.run('afterStep', partOfStep);
    return read;
  }

  /** What is told of the step is told with the time at its end. */
  #stepBullet(seconds: number, parts: number): void {
    const { engine, bullet, timeStep } = this.#world;
    engine.forgetFound(bullet.bullet);
    engine.solverHook.listen(this.#between);
    engine.stages.listen(this.#between);
    bullet.step(seconds);
    engine.solverHook.listen(null);
    engine.stages.listen(null);
    this.#time.count(timeStep, parts);
  }

  /** In the middle of Bullet's step. */
  readonly #between: SolverListener & { islands(): void } = {
    islands: () => this.#world.bullet.order?.nameIslands(),
    found: () => {
      const { bullet, registry: effects, partOfStep } = this.#world;
      bullet.order?.sortManifolds();
      effects.found();
      effects.run('found', partOfStep);
      effects.seeContacts();
      effects.run('solve', partOfStep);
      bullet.order?.setAside();
    },
    solved: () => {
      const { bullet, registry: effects, partOfStep } = this.#world;
      bullet.order?.putBack();
      effects.run('solved', partOfStep);
    },
  };

  /** Where its code is not here there are no contacts. */
  #reportContacts(): void {
    const first = this.#first;
    this.#first = false;
    if (!contacts.here) return;
    if (first) contacts.code.reportOverlaps(this.#world);
    this.#hardContacts ??= contacts.code.hardContacts(this.#world);
    this.#hardContacts.look(this.#world.partOfStep);
  }

  #read(): number {
    const start = performance.now();
    this.#world.bodies.read();
    return this.#costs.spent('read', start);
  }

  // ---- listeners --------------------------------------------------------------------------------------------------

  #tell(name: 'beforestep' | 'afterstep'): void {
    const { events, time, timeStep } = this.#world;
    if (!this.#world.heard(name)) return;
    const start = performance.now();
    this.#world.emit(name, { time, timeStep });
    events.deliver();
    this.#costs.spent('events', start);
  }

  #hold(): void {
    this.#world.events.hold();
  }

  #release(): void {
    const { events } = this.#world;
    if (!events.waiting) return events.release();
    const start = performance.now();
    events.release();
    // A listener of something else may have asked for the step.
    events.deliver();
    this.#costs.spent('events', start);
  }
}
