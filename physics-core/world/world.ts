import type { Listener } from '../base/emitter.js';
import type { EventQueue } from '../base/event-queue.js';
import type { Problem, ProblemReport } from '../base/problems.js';
import { show } from '../base/show.js';
import { AUTO, levels, type Level, type LevelName } from '../dynamics/levels.js';
import { Poses } from '../dynamics/poses.js';
import { allEffects } from '../effects/all.js';
import { contactSurface } from '../effects/contacts/contact-surface.js';
import { frameCosts, type Costs } from '../effects/costs/frame-costs.js';
import { userTiming } from '../effects/costs/user-timing.js';
import type { Cause } from '../effects/effect/effect.js';
import { Effects, type EffectReport } from '../effects/effect/effects.js';
import { JointRows } from '../effects/joints/joint-rows.js';
import type { BulletWorld } from '../engine/bullet-world.js';
import type { Engine } from '../engine/engine.js';
import type { Vec3 } from '../fields/types.js';
import type { BodyNode } from '../nodes/body/body.js';
import type { NodeData } from '../nodes/node/node-data.js';
import type { JointSettings } from '../nodes/node/node-world.js';
import type { PhysicsNode } from '../nodes/node/node.js';
import { nodeTypes } from '../nodes/index.js';
import { LevelControl } from './accuracy/level-control.js';
import { BodySlots } from './bodies/body-slots.js';
import { Editing } from './store/editing.js';
import { Failures } from './store/failures.js';
import { HeapLimit } from './store/heap-limit.js';
import { Lifecycle } from './lifecycle.js';
import { measure, type LevelMeasurement, type MeasureOptions } from './measuring.js';
import { NodeStore } from './store/node-store.js';
import { Obstacles } from './pairs/obstacles.js';
import { Pairs } from './pairs/pairs.js';
import { Rays, type RayHit } from './raycast.js';
import { Reporting } from './store/reporting.js';
import { restoreSnapshot } from './snapshot/restore.js';
import type { Snapshot } from './snapshot/snapshot.js';
import { takeSnapshot } from './snapshot/take.js';
import { statsOf } from './stats.js';
import { Stepping, type TimedWorld } from './stepping/stepping.js';
import type { AddOptions, Stats, WorldOptions } from './store/types.js';

/** A world of X3D nodes on a Bullet world. It exists before the engine does; `start` builds what was added so far. */
export class World implements TimedWorld {
  engine!: Engine;
  bullet!: BulletWorld;
  /** Whether there is a Bullet world. */
  started = false;
  /** FALSE on the first collection freezes the world. */
  enabled = true;
  /** Tells the page's loop that there is work again. */
  onwork?: () => void;

  readonly #reporting: Reporting;
  readonly #store = new NodeStore(this);
  readonly poses = new Poses();
  readonly bodies: BodySlots = new BodySlots(this, this.poses);
  readonly registry: Effects = new Effects(this, allEffects);
  readonly pairs: Pairs = new Pairs(this, this.bodies);
  readonly jointRows: JointRows = new JointRows(this);
  readonly stepping: Stepping = new Stepping(this);
  readonly counts = { created: 0, patched: 0, destroyed: 0 };
  readonly obstacles: Obstacles = new Obstacles(this, this.pairs);
  readonly rays: Rays = new Rays(this);
  readonly heapLimit: HeapLimit;
  readonly failures: Failures;
  readonly edits: Editing;
  readonly control: LevelControl;
  readonly lifecycle: Lifecycle = new Lifecycle(this);
  readonly #profiling: Cause = { host: this };

  constructor(options: WorldOptions = {}) {
    this.#reporting = new Reporting(options.console ?? false);
    const lengthen = (from: number, to: number): void => this.stepping.lengthen(from, to);
    this.control = new LevelControl(this, lengthen, options.level);
    this.heapLimit = new HeapLimit(this, () => (this.paused = true), options.maxHeapBytes);
    this.failures = new Failures(this, this.heapLimit);
    this.edits = new Editing(this, this.obstacles, this.heapLimit, this.control);
  }

  // ---- nodes ------------------------------------------------------------------------------------------------------

  get nodes(): Iterable<PhysicsNode> {
    return this.#store.all;
  }

  /** The RigidBodyCollections that share this world. */
  get rigidBodyCollections(): Iterable<PhysicsNode> {
    return this.#store.collections;
  }

  /** Settings of the world: its first collection's, or X3D's defaults. */
  get settings(): PhysicsNode {
    return this.#store.settings;
  }

  /** Adds a node of an X3D type. Field values are X3D's, in SI units; nodes may be given as nodes or plain data. */
  add(type: string, fields: Record<string, unknown> = {}, options: AddOptions = {}): PhysicsNode {
    if (!nodeTypes[type]) throw new TypeError(`x3d-physics has no node type ${show(type)}`);
    return this.events.during(() => this.#store.add(type, fields, options));
  }

  addData(data: NodeData, parent: PhysicsNode, types: readonly string[]): PhysicsNode | undefined {
    return this.#store.addData(data, parent, types);
  }

  /** The node with this DEF, id, or host; the last one where several have it. */
  node(nameOrHost: unknown): PhysicsNode | undefined {
    return this.#store.find(nameOrHost);
  }

  forget(node: PhysicsNode): void {
    this.#store.forget(node);
    this.edits.drop(node);
    this.takeBack(node);
    this.work();
  }

  /** The world is its first RigidBodyCollection. */
  get(field: string): unknown {
    return this.settings.get(field);
  }

  set(field: string, value: unknown): void {
    if (this.#store.collections.size === 0) this.add('RigidBodyCollection');
    this.settings.set(field, value);
  }

  bodyAt(pointer: number): BodyNode | undefined {
    return this.bodies.behind(pointer);
  }

  // ---- edits ------------------------------------------------------------------------------------------------------

  enqueue(node: PhysicsNode): void {
    if (node === this.#store.defaults) return;
    this.edits.add(node);
    this.work();
  }

  work(): void {
    this.onwork?.();
  }

  /** Whether edits wait for the next step or frame. */
  get pending(): boolean {
    return this.edits.pending;
  }

  /** Applies pending edits. */
  flush(): void {
    if (this.started) this.edits.flush();
  }

  contactParametersChanged(body: BodyNode): void {
    if (!body.built) return;
    const reason = this.registry.find(contactSurface);
    if (reason || this.pairs.collections.length > 0) this.registry.get(contactSurface).update(body);
  }

  // ---- start, reset, end ------------------------------------------------------------------------------------------

  /** Settles when the world has started; rejects with the problem if it can't. */
  get ready(): Promise<this> {
    return this.lifecycle.ready.promise as Promise<this>;
  }

  /** After a failed attempt to start another one is made: who asks for `ready` from now on hears how that ends. */
  awaitStart(): void {
    this.lifecycle.ready.await();
  }

  /** The world can't start: `ready` rejects with the problem. */
  fail(problem: unknown): void {
    this.lifecycle.ready.reject(problem);
  }

  /** Builds everything added so far, in order, and settles `ready`. */
  start(engine: Engine): void {
    this.lifecycle.start(engine);
  }

  /** Back to what the markup says, at time 0. The next n steps are the first n steps, bit for bit. */
  reset(): void {
    this.lifecycle.reset();
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

  destroy(): void {
    this.lifecycle.destroy();
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
    return measure(this, this.snapshot(), options);
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
    this.#store.compareCollections();
    this.work();
  }

  /** What Bullet's solver works with now. */
  configureSolver(): void {
    this.control.configureSolver();
  }

  // ---- time -------------------------------------------------------------------------------------------------------

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

  get stepsTaken(): number {
    return this.stepping.taken;
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

  /** The page has drawn: it began to write poses at `start`, on the clock of `performance.now()`. */
  frameOver(start: number): void {
    this.stepping.frameOver(start);
  }

  // ---- problems and events ----------------------------------------------------------------------------------------

  get problems(): Problem[] {
    return this.#reporting.all;
  }

  problemsOf(about: unknown): Problem[] {
    return this.#reporting.of(about);
  }

  report(report: ProblemReport, about: unknown = this): void {
    this.#reporting.report(report, about);
  }

  settle(about: unknown, attribute?: string, code?: string): void {
    this.#reporting.settle(about, attribute, code);
  }

  /** A node is gone, and with it what it reported; what others say of its element stands. */
  takeBack(node: PhysicsNode): void {
    for (const { attribute, code } of this.#reporting.by(node))
      this.settle(node.host, attribute, code);
  }

  /** Its own events and those of its nodes, on their way to listeners. */
  get events(): EventQueue {
    return this.#reporting.events;
  }

  on(event: string, listener: Listener): () => void {
    return this.#reporting.on(event, listener);
  }

  heard(event: string): boolean {
    return this.#reporting.heard(event);
  }

  emit(event: string, detail: unknown): void {
    this.#reporting.emit(event, detail);
  }

  // ---- looking in -------------------------------------------------------------------------------------------------

  /** The first thing on the way between two points (world frame, metres), or null. */
  raycast(from: Vec3, to: Vec3): RayHit | null {
    return this.rays.cast(from, to);
  }

  get stats(): Stats {
    return statsOf(this, this.stepping.ms);
  }

  /** What the scene has switched on, because of which element, at what cost. */
  get effects(): EffectReport[] {
    return this.registry.report();
  }

  /** What frames cost of late, while `recordCosts` asks for it. */
  get costs(): Costs | undefined {
    return this.registry.find(frameCosts)?.report;
  }

  /** Keeps what frames cost, for `costs`; `who` looks stands in `effects`. Returns how to stop. */
  recordCosts(who: unknown, reason = 'costs'): () => void {
    return this.registry.get(frameCosts).record(who, reason);
  }

  /** Whether the browser's Performance panel is told of each phase (User Timing). */
  get profile(): boolean {
    return this.registry.active(userTiming);
  }

  set profile(on: boolean) {
    if (on) this.registry.get(userTiming).need(this.#profiling, 'profile');
    else this.registry.find(userTiming)?.release(this.#profiling);
  }
}
