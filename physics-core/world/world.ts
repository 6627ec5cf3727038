import type { Listener } from '../base/emitter.js';
import type { EventQueue } from '../base/event-queue.js';
import type { Problem, ProblemReport } from '../base/problems.js';
import { AUTO, ladder, type Level, type LevelName } from '../dynamics/levels.js';
import { Poses } from '../dynamics/poses.js';
import { allEffects } from '../effects/all.js';
import { costs, frameCosts, userTiming } from '../effects/costs/effects.js';
import type { Costs } from '../effects/costs/phases.js';
import type { ColorMeaning } from '../effects/debug/colors.js';
import { debugging, outlines } from '../effects/debug/debugging.js';
import { Effects } from '../effects/effect/effects.js';
import type { EffectReport } from '../effects/effect/report.js';
import type { BulletWorld } from '../engine/bullet-world.js';
import type { Engine } from '../engine/engine.js';
import type { Vec3 } from '../fields/types.js';
import type { BodyNode } from '../nodes/body/body.js';
import type { JointSettings, PairRules } from '../nodes/node/node-world.js';
import type { PhysicsNode } from '../nodes/node/node.js';
import { threads } from '../nodes/node/threads.js';
import { LevelControl } from './accuracy/level-control.js';
import { BodySlots } from './bodies/body-slots.js';
import { Awaiting } from './store/awaiting.js';
import { Editing } from './store/editing.js';
import { Failures } from './store/failures.js';
import { HeapLimit } from './store/heap-limit.js';
import { Lifecycle } from './lifecycle/lifecycle.js';
import { measure, type LevelMeasurement, type MeasureOptions, type Watching } from './measuring.js';
import { NodeStore } from './store/node-store.js';
import { alone, meeting, type Meeting, type ObstacleRules } from './pairs/alone.js';
import { Rays, type RayHit } from './rays/raycast.js';
import {
  recordings,
  type Recorder,
  type RecordOptions,
  type Run,
  type Timeline,
} from './recording.js';
import { Reporting } from './store/reporting.js';
import { dense } from './snapshot/dense.js';
import { restoreSnapshot } from './snapshot/restore.js';
import type { Snapshot } from './snapshot/snapshot.js';
import { takeSnapshot } from './snapshot/take.js';
import { statsOf } from './stats.js';
import { Stepping, type TimedWorld } from './stepping/stepping.js';
import type { Bound, Elsewhere } from './threading.js';
import type { AddOptions, Stats, WorldOptions } from './store/types.js';

/**
 * A world of X3D nodes on a Bullet world, put together from its parts. It exists before the engine does; `start` builds
 * what was added so far. What people see of it is documented in face/world.ts.
 */
export class World implements TimedWorld {
  engine!: Engine;
  bullet!: BulletWorld;
  /** Whether there is a Bullet world. */
  started = false;
  /** Tells the page's loop that there is work again. */
  onwork?: () => void;
  /** While it is recorded. */
  timeline: Recorder | undefined = undefined;
  /** While its steps are taken on another thread. */
  elsewhere: Elsewhere | undefined = undefined;
  /** What keeps it on this one. */
  bound: Bound | undefined = undefined;

  readonly #reporting: Reporting;
  #profile = false;
  #meeting: Meeting = alone;
  readonly store: NodeStore = new NodeStore(this);
  readonly poses = new Poses();
  readonly bodies: BodySlots = new BodySlots(this, this.poses);
  readonly registry: Effects = new Effects(this, allEffects);
  stepping: Stepping = new Stepping(this);
  readonly counts = { created: 0, patched: 0, destroyed: 0 };
  readonly rays: Rays = new Rays(this);
  readonly heapLimit: HeapLimit;
  readonly failures: Failures;
  readonly edits: Editing;
  readonly awaiting: Awaiting = new Awaiting(this);
  readonly control: LevelControl;
  readonly lifecycle: Lifecycle = new Lifecycle(this);

  constructor(options: WorldOptions = {}) {
    this.#reporting = new Reporting(options.console ?? false);
    const lengthen = (from: number, to: number): void => this.stepping.lengthen(from, to);
    this.control = new LevelControl(this, lengthen, options.level);
    this.heapLimit = new HeapLimit(this, () => (this.paused = true), options.maxHeapBytes);
    this.failures = new Failures(this, this.heapLimit);
    this.edits = new Editing(this, this.awaiting, this.heapLimit, this.control);
  }

  // ---- nodes ------------------------------------------------------------------------------------------------------

  get nodes(): Iterable<PhysicsNode> {
    return this.store.all;
  }

  /** Settings of the world: its first collection's, or X3D's defaults. */
  get settings(): PhysicsNode {
    return this.store.settings;
  }

  add(type: string, fields: Record<string, unknown> = {}, options: AddOptions = {}): PhysicsNode {
    return this.events.call(this, 'add', [type, fields, options], () =>
      this.store.add(type, fields, options),
    );
  }

  node(nameOrHost: unknown): PhysicsNode | undefined {
    return this.store.find(nameOrHost);
  }

  /** The world is its first RigidBodyCollection. */
  get(field: string): unknown {
    return this.settings.get(field);
  }

  set(field: string, value: unknown): void {
    this.store.firstCollection().set(field, value);
  }

  get pairs(): PairRules {
    return this.#meeting.pairs;
  }

  get obstacles(): ObstacleRules {
    return this.#meeting.obstacles;
  }

  bodyAt(pointer: number): BodyNode | undefined {
    return this.bodies.behind(pointer);
  }

  // ---- edits ------------------------------------------------------------------------------------------------------

  work(): void {
    this.onwork?.();
  }

  /** Code has come that it may have waited for. */
  codeCame(): void {
    this.store.codeCame();
    if (this.#meeting !== alone || !meeting.of) return;
    this.#meeting = meeting.of(this, this.bodies);
    this.pairs.refresh();
  }

  /** Applies pending edits. */
  flush(): void {
    if (this.started) this.edits.flush();
  }

  // ---- start, reset, end ------------------------------------------------------------------------------------------

  /** Settles when the world has started; rejects with the problem if it can't. */
  get ready(): Promise<this> {
    return this.lifecycle.ready.promise as Promise<this>;
  }

  /** Builds everything added so far, in order, and settles `ready`. */
  start(engine: Engine): void {
    this.lifecycle.start(engine);
  }

  reset(): void {
    this.lifecycle.reset();
  }

  snapshot(): Snapshot {
    if (this.elsewhere) return this.elsewhere.refuse('snapshot') as unknown as Snapshot;
    // The next one is dense.
    void dense.load().catch(() => {});
    return this.timeline?.looking ? this.timeline.snapshot() : takeSnapshot(this);
  }

  restore(snapshot: Snapshot): void {
    this.events.anew(() => restoreSnapshot(this, snapshot));
    this.elsewhere?.restored(snapshot);
  }

  record(options: RecordOptions = {}): Promise<Timeline> {
    return this.#recording((code) => code.record(this, options));
  }

  /** Does something with that code: at once where it is here. */
  async #recording<T>(work: (code: typeof recordings.code) => T): Promise<Awaited<T>> {
    if (!this.started) await this.ready;
    if (!recordings.here) await recordings.load();
    return await work(recordings.code);
  }

  resume(): void {
    this.timeline?.resume();
  }

  exportRun(): Run | undefined {
    return this.timeline?.exportRun();
  }

  importRun(run: Run, watching: Watching = {}): Promise<Timeline | undefined> {
    return this.#recording((code) => code.importRun(this, run, watching));
  }

  destroy(): void {
    this.elsewhere?.end();
    this.timeline = this.events.keeper = undefined;
    this.lifecycle.destroy();
  }

  // ---- accuracy ---------------------------------------------------------------------------------------------------

  get accuracy(): LevelName {
    return this.control.level.name;
  }

  set accuracy(name: LevelName | typeof AUTO) {
    this.set('accuracy', name);
    this.flush();
  }

  get levels(): (Level & { active: boolean })[] {
    return ladder(this.accuracy);
  }

  async measureAccuracy(options: MeasureOptions = {}): Promise<LevelMeasurement[]> {
    if (!this.started) await this.ready;
    return measure(this, options);
  }

  get timeStep(): number {
    return this.control.level.timeStep;
  }

  get partOfStep(): number {
    return this.control.partOfStep;
  }

  get solver(): JointSettings {
    return this.control.joints;
  }

  /** Takes the settings of the first collection into Bullet. */
  configure(): void {
    if (!this.started) return;
    this.control.configure();
    this.store.compareCollections();
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

  get time(): number {
    return this.stepping.time;
  }

  get stepsTaken(): number {
    return this.stepping.taken;
  }

  get timeScale(): number {
    return this.stepping.timeScale;
  }

  set timeScale(scale: number) {
    this.stepping.timeScale = scale;
  }

  step(n = 1): number {
    return this.stepping.step(n);
  }

  advance(seconds: number): number {
    // A pending edit may change the level, and with it the length of a step.
    this.flush();
    return this.step(Math.round(seconds / this.timeStep));
  }

  /** See `Stepping`. */
  frame(seconds: number, seen = true): boolean {
    return this.stepping.frame(seconds, seen);
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

  /** Makes all anew, with nothing told twice. */
  retelling(make: () => void): void {
    this.#reporting.anew(make);
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
    const stop = this.#reporting.on(event, listener);
    this.events.listened(this, event);
    return stop;
  }

  heard(event: string): boolean {
    return this.#reporting.heard(event);
  }

  emit(event: string, detail: unknown): void {
    this.#reporting.emit(event, detail);
  }

  // ---- looking in -------------------------------------------------------------------------------------------------

  raycast(from: Vec3, to: Vec3, also?: { water?: boolean }): RayHit | null {
    if (this.elsewhere) return this.elsewhere.refuse('raycast');
    return this.rays.cast(from, to, also?.water);
  }

  get stats(): Stats {
    return this.elsewhere?.stats ?? statsOf(this, this.stepping);
  }

  get effects(): EffectReport[] {
    return this.elsewhere?.effects ?? this.registry.report();
  }

  // ---- another thread ---------------------------------------------------------------------------------------------

  /** Something acts on it that has to do so in its step: from now on it runs on this thread. */
  stay(bound: Bound): void {
    this.bound = bound;
    void this.elsewhere?.comeBack(bound);
  }

  get mirrored(): number | undefined {
    return this.elsewhere?.step;
  }

  async ask(method: string, ...args: unknown[]): Promise<unknown> {
    if (!this.started) await this.ready;
    if (!threads.here) await threads.load();
    return threads.code.ask(this, method, args);
  }

  /** What the colours of the debug drawing mean; nothing while it is off. */
  get debugLegend(): readonly ColorMeaning[] {
    return outlines.here && this.registry.active(debugging) ? outlines.code.legend : [];
  }

  get costs(): Costs | undefined {
    return this.registry.find(frameCosts)?.report;
  }

  recordCosts(who: unknown, reason = 'costs'): () => void {
    let stop: (() => void) | undefined;
    let over = false;
    costs.whenHere(() => {
      if (!over) stop = this.registry.get(frameCosts).record(who, reason);
    });
    return () => {
      over = true;
      stop?.();
    };
  }

  get profile(): boolean {
    return this.#profile;
  }

  set profile(on: boolean) {
    this.#profile = on;
    costs.whenHere(() => this.registry.get(userTiming).turn(this.#profile, this));
  }
}
