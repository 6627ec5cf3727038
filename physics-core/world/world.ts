import { AUTO, levels, type Level, type LevelName } from '../dynamics/levels.js';
import type { Costs } from '../effects/costs/frame-costs.js';
import type { LevelMeasurement, MeasureOptions } from '../accuracy/measure.js';
import { EffectRegistry, type EffectReport } from '../effects/registry.js';
import { BulletWorld } from '../engine/bullet-world.js';
import type { Engine } from '../engine/engine.js';
import type { Vec3 } from '../fields/types.js';
import type { MovingNode } from '../nodes/body-motion.js';
import type { BodyNode } from '../nodes/body.js';
import type { PhysicsNode } from '../nodes/node.js';
import { Accuracy } from './accuracy.js';
import { Bodies } from './bodies.js';
import { RANKS } from './edits.js';
import { Failures } from './failures.js';
import { HeapLimit } from './heap-limit.js';
import { NodeWorld } from './node-world.js';
import { Obstacles } from './obstacles.js';
import { Pairs } from './pairs.js';
import { Poses } from '../dynamics/poses.js';
import { Rays, type RayHit } from './raycast.js';
import type { JointSettings } from './solver-settings.js';
import { restoreSnapshot, takeSnapshot, type Snapshot } from './snapshot.js';
import { statsOf } from './stats.js';
import { Stepping } from './stepping.js';
import type { Stats, WorldOptions } from './types.js';

/** A world of X3D nodes on a Bullet world. It exists before the engine does; `start` builds what was added so far. */
export class World extends NodeWorld {
  #ready!: Promise<World>;
  engine!: Engine;
  bullet!: BulletWorld;
  readonly poses = new Poses();
  readonly bodies: Bodies = new Bodies(this, this.poses);
  readonly registry: EffectRegistry;
  readonly pairs: Pairs = new Pairs(this);
  readonly obstacles: Obstacles = new Obstacles(this);
  readonly rays: Rays = new Rays(this);
  readonly heapLimit: HeapLimit;
  readonly failures: Failures = new Failures(this);
  readonly stepping: Stepping = new Stepping(this);
  readonly counts = { created: 0, patched: 0, destroyed: 0 };
  started = false;
  /** FALSE on the first collection freezes the world. */
  enabled = true;

  readonly control: Accuracy;
  #settleReady: { resolve: (world: World) => void; reject: (problem: unknown) => void } | undefined;

  constructor(options: WorldOptions = {}) {
    super(options.console ?? false);
    this.control = new Accuracy(this, options.level);
    this.heapLimit = new HeapLimit(this, options.maxHeapBytes);
    this.registry = new EffectRegistry(this);
    this.awaitStart();
  }

  /** Settles when the world has started; rejects with the problem if it can't. */
  get ready(): Promise<World> {
    return this.#ready;
  }

  /** After a failed attempt to start another one is made: who asks for `ready` from now on hears how that ends. */
  awaitStart(): void {
    if (this.#settleReady) return;
    this.#ready = new Promise((resolve, reject) => (this.#settleReady = { resolve, reject }));
    // Nobody need listen; who awaits still hears.
    this.#ready.catch(() => {});
  }

  bodyAt(pointer: number): BodyNode | undefined {
    return this.bodies.behind(pointer);
  }

  // ---- edits ----------------------------------------------------------------------------------------------------

  /** Applies pending edits. */
  flush(): void {
    if (this.started) this.events.during(this.#applyAll);
  }

  readonly #applyAll = (): void => {
    do this.edits.applyAll(this.#apply);
    while (this.obstacles.update());
    this.control.tell();
  };

  readonly #apply = (node: PhysicsNode): void =>
    this.failures.attempt(node, () => {
      if (!node.built) this.heapLimit.check();
      node.apply();
    });

  // ---- start, reset, end ------------------------------------------------------------------------------------------

  /** Builds everything added so far, in order, and settles `ready`. */
  start(engine: Engine): void {
    if (this.started) return;
    this.engine = engine;
    this.events.during(() => {
      this.#build();
      this.flush();
      this.awaitStart();
      this.#settleReady!.resolve(this);
      this.emit('ready', this);
      this.work();
    });
  }

  /** The same in pieces, unheard: each `next` makes one node, so that nobody need be held up. */
  *starting(engine: Engine): Generator<void> {
    this.engine = engine;
    this.#build();
    do while (this.edits.applyNext(this.#apply)) yield;
    while (this.obstacles.update());
  }

  /** The world can't start: `ready` rejects with the problem. */
  fail(problem: unknown): void {
    this.#settleReady?.reject(problem);
    this.#settleReady = undefined;
  }

  #build(): void {
    this.bullet = new BulletWorld(this.engine);
    this.started = true;
    if (!this.engine.heapTrusted) this.#reportUnknownBuild();
    this.configure();
    this.stepping.restart();
  }

  #reportUnknownBuild(): void {
    this.report({
      code: 'unknown-ammo-build',
      severity: 'warning',
      used: "Bullet's own settings",
      message:
        "the memory of this Ammo build is laid out in another way: the parameters of CollisionCollections, the level's solver settings and rest are left out",
    });
  }

  /** Back to what the markup says, at time 0. The next n steps are the first n steps, bit for bit. */
  reset(): void {
    if (!this.started) return;
    this.flush();
    this.events.anew(() => {
      const tellWoken = this.bodies.sleepers();
      this.rebuild(() => {
        this.stepping.setTime(0);
        this.registry.resting.sinceLook = 0;
        this.control.begin();
        for (const node of this.nodes) node.forgetEvents();
      });
      tellWoken();
      this.emit('reset', this);
    });
  }

  /** The state of everything, as plain data: it may be kept, cloned, or sent elsewhere. */
  snapshot(): Snapshot {
    return takeSnapshot(this);
  }

  /**
   * Back to a snapshot of this world, without contacts: two restores of one snapshot run alike, bit for bit. What was
   * added since starts from its markup; what was removed since stays away.
   */
  restore(snapshot: Snapshot): void {
    this.events.anew(() => restoreSnapshot(this, snapshot));
  }

  /** The same nodes in a fresh Bullet world; `between`: what changes while nothing stands in any. */
  rebuild(between: () => void): void {
    this.registry.contacts.reset();
    this.registry.given.reset();
    this.registry.dragging.reset('reset');
    this.#unbuild();
    between();
    this.#build();
    for (const node of this.nodes) this.enqueue(node);
    this.flush();
  }

  /** Newest first: joints before the bodies they hold. */
  #unbuild(): void {
    this.obstacles.clear();
    const nodes = [...this.nodes].toReversed();
    for (let rank = RANKS - 1; rank >= 0; rank--) {
      for (const node of nodes) if (node.type.rank === rank) node.unmake();
    }
    this.rays.dispose();
    this.bullet.dispose();
    this.started = false;
  }

  destroy(): void {
    this.events.anew(() => {
      if (this.started) {
        this.registry.contacts.reset('removed');
        this.registry.dragging.reset('removed');
        this.#unbuild();
      }
      for (const node of [...this.nodes]) node.remove();
    });
  }

  // ---- accuracy ---------------------------------------------------------------------------------------------------

  /** The level in force. */
  get accuracy(): LevelName {
    return this.control.level.name;
  }

  set accuracy(name: LevelName | typeof AUTO) {
    this.set('accuracy', name);
    this.flush();
  }

  /** The ladder; `active` marks the level in force. */
  get levels(): (Level & { active: boolean })[] {
    return levels.map((level) => ({ ...level, active: level.name === this.accuracy }));
  }

  /** What each level costs and leaves, in the scene as it is now: run anew in a second world, in a worker where there are any. */
  async measureAccuracy(options: MeasureOptions = {}): Promise<LevelMeasurement[]> {
    if (!this.started) await this.ready;
    const snapshot = this.snapshot();
    const { measureAccuracy } = await import('../accuracy/measure.js');
    return measureAccuracy(this, snapshot, options);
  }

  /** Seconds of one step. */
  get timeStep(): number {
    return this.control.level.timeStep;
  }

  get solver(): JointSettings {
    return this.control.joints;
  }

  /** Takes the settings of the first collection into Bullet. */
  configure(): void {
    if (!this.started) return;
    this.enabled = this.settings.asked('enabled');
    this.control.configure();
    this.work();
  }

  /** What Bullet's solver works with now. */
  configureSolver(): void {
    this.control.configureSolver();
  }

  // ---- time -----------------------------------------------------------------------------------------------------

  get paused(): boolean {
    return this.stepping.paused;
  }

  set paused(paused: boolean) {
    this.stepping.paused = paused;
  }

  /** Simulated seconds since the start or the last reset. */
  get time(): number {
    return this.stepping.time;
  }

  /** Simulated seconds per second of the clock; 0 stands still. */
  get timeScale(): number {
    return this.stepping.timeScale;
  }

  set timeScale(scale: number) {
    this.stepping.timeScale = scale;
  }

  /**
   * Advances n steps at once, paused or not; returns the seconds advanced. `step(0)` applies pending edits. Within a
   * step (a listener of what it brought about) it does nothing.
   */
  step(n = 1): number {
    return this.stepping.step(n);
  }

  /** Advances by as many whole steps as come nearest to `seconds`. */
  advance(seconds: number): number {
    // A pending edit may change the level, and with it the length of a step.
    this.flush();
    return this.step(Math.round(seconds / this.timeStep));
  }

  /**
   * Advances by wall time in fixed steps and places what is drawn between the last two. Returns `needsFrame`. `seen`:
   * somebody waits for the frame, so that accuracy auto is to judge by it.
   */
  frame(seconds: number, seen = true): boolean {
    return this.stepping.frame(seconds, seen);
  }

  /** Whether time passes by itself. */
  get running(): boolean {
    return this.stepping.running;
  }

  /** Whether the next frame has anything to do. */
  get needsFrame(): boolean {
    return this.stepping.needsFrame;
  }

  // ---- what bodies ask of it --------------------------------------------------------------------------------------

  push(body: MovingNode, force: Vec3, torque: Vec3): void {
    this.registry.forces.push(body, force, torque);
  }

  contactParametersChanged(body: BodyNode): void {
    if (body.built) this.registry.surface.update(body);
  }

  // ---- looking in -------------------------------------------------------------------------------------------------

  /** The first thing on the way between two points (world frame, metres), or null. */
  raycast(from: Vec3, to: Vec3): RayHit | null {
    return this.rays.cast(from, to);
  }

  get stats(): Stats {
    return statsOf(this);
  }

  get effects(): EffectReport[] {
    return this.registry.report();
  }

  /** What frames cost of late, while `recordCosts` asks for it. */
  get costs(): Costs | undefined {
    return this.registry.costs.report;
  }

  /** Keeps what frames cost, for `costs`; `who` looks stands in `effects`. Returns how to stop. */
  recordCosts(who: unknown, reason = 'costs'): () => void {
    return this.registry.costs.record(who, reason);
  }

  /** Whether the browser's Performance panel is told of each phase (User Timing). */
  get profile(): boolean {
    return this.registry.timing.active;
  }

  set profile(on: boolean) {
    this.registry.timing.turn(on);
  }

  /** The page has drawn: it began to write poses at `start`, on the clock of `performance.now()`. */
  frameOver(start: number): void {
    this.stepping.frameOver(start);
  }
}
