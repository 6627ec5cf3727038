import {
  DEFAULT_LEVEL,
  levelNamed,
  levels,
  type Level,
  type LevelName,
} from '../accuracy/levels.js';
import { Clock } from '../clock.js';
import { EffectRegistry, type EffectReport } from '../effects/registry.js';
import { Emitter, type Listener } from '../emitter.js';
import { BulletWorld } from '../engine/bullet-world.js';
import type { Engine } from '../engine/engine.js';
import type { Vec3 } from '../fields/types.js';
import { nodeTypes } from '../nodes/index.js';
import { BodyNode } from '../nodes/body.js';
import { JointNode } from '../nodes/joint.js';
import { PhysicsNode, type NodeData } from '../nodes/node.js';
import type { CollectionNode } from '../nodes/rigid-body-collection.js';
import { ProblemLog, type Problem, type ProblemReport } from '../problems.js';
import { Bodies } from './bodies.js';
import { Edits, RANKS } from './edits.js';
import { reportOverlaps } from './overlaps.js';
import { Pairs } from './pairs.js';
import { Poses } from './poses.js';
import { jointSettings, levelOf, solverSettings, type JointSettings } from './solver-settings.js';
import type { AddOptions, Stats, WorldOptions } from './types.js';

/** Wall time that the steps of one frame may take, milliseconds; what is left over is dropped and reported. */
const FRAME_BUDGET = 50;

/** Seconds dropped before authors are told: the first frames of any page are slow. */
const MUCH_LOST = 1;

/** Share of the heap limit from which an author is warned. */
const HEAP_LOW = 0.9;
const DEFAULT_HEAP = 512 * 2 ** 20;

/** A world of X3D nodes on a Bullet world. It exists before the engine does; `start` builds what was added so far. */
export class World {
  readonly ready: Promise<World>;
  engine!: Engine;
  bullet!: BulletWorld;
  readonly poses = new Poses();
  readonly bodies: Bodies = new Bodies(this, this.poses);
  readonly pairs: Pairs = new Pairs(this);
  readonly registry: EffectRegistry;
  readonly counts = { created: 0, patched: 0, destroyed: 0 };
  /** Tells the page's loop that there is work again. */
  onwork?: () => void;
  started = false;

  #paused = false;
  /** Seconds dropped so far. */
  #lost = 0;
  #timeScale = 1;
  /** Steps since the step last changed its length, and the time that was then: sums of steps would round. */
  #steps = 0;
  #timeBefore = 0;
  #stepping = false;
  /** The next step is the first one: bodies may begin inside each other. */
  #first = true;
  #level: Level = levelNamed(DEFAULT_LEVEL);
  #solver!: JointSettings;
  #enabled = true;
  #nextId = 1;
  readonly #maxHeapBytes: number;
  readonly #nodes = new Set<PhysicsNode>();
  readonly #collections = new Set<CollectionNode>();
  readonly #defaults: CollectionNode;
  readonly #edits = new Edits();
  readonly #clock = new Clock();
  readonly #problems: ProblemLog;
  readonly #emitter = new Emitter();
  readonly #ms = { step: 0, read: 0, write: 0, events: 0 };
  #settleReady!: { resolve: (world: World) => void; reject: (problem: unknown) => void };

  constructor(options: WorldOptions = {}) {
    this.#maxHeapBytes = options.maxHeapBytes ?? DEFAULT_HEAP;
    this.#problems = new ProblemLog(options.console ?? false);
    this.#problems.onreport = (problem) => this.#emitter.emit('problem', problem);
    this.registry = new EffectRegistry(this);
    this.ready = new Promise((resolve, reject) => (this.#settleReady = { resolve, reject }));
    // Nobody need listen; who awaits still hears.
    this.ready.catch(() => {});
    this.#defaults = this.#construct('RigidBodyCollection', {}) as CollectionNode;
  }

  // ---- nodes ----------------------------------------------------------------------------------------------------

  /** Adds a node of an X3D type. Field values are X3D's, in SI units; nodes may be given as nodes or plain data. */
  add(type: string, fields: Record<string, unknown> = {}, options: AddOptions = {}): PhysicsNode {
    if (!nodeTypes[type]) throw new TypeError(`x3d-physics has no node type ${type}`);
    const node = this.#construct(type, options);
    this.#nodes.add(node);
    if (type === 'RigidBodyCollection') this.#collections.add(node as CollectionNode);
    if (node instanceof BodyNode && options.start) node.start = options.start;
    for (const [name, value] of Object.entries(fields)) node.set(name, value);
    this.enqueue(node);
    return node;
  }

  #construct(type: string, options: AddOptions): PhysicsNode {
    const nodeType = nodeTypes[type]!;
    return nodeType.make({
      world: this,
      type: nodeType,
      id: this.#nextId++,
      host: options.host,
      name: options.name,
      collection: options.collection as CollectionNode | undefined,
    });
  }

  /** A node from plain data in a field that takes `types`: bare geometry becomes a CollidableShape. */
  addData(data: NodeData, parent: PhysicsNode, types: readonly string[]): PhysicsNode | undefined {
    const { type, ...fields } = data;
    const options = {
      collection: parent.collection,
      host: parent.host === parent ? undefined : parent.host,
    };
    if (types.includes(type))
      return nodeTypes[type] ? this.add(type, fields, options) : (data as never);
    if (types.includes('CollidableShape'))
      return this.add('CollidableShape', { shape: [data] }, options);
    parent.report({
      code: 'misplaced',
      severity: 'warning',
      value: type,
      message: `${parent.label}: a ${type} has no place here; ${types.join(' or ')} has`,
    });
    return undefined;
  }

  /** The node with this DEF, id, or host; the last one where several have it. */
  node(nameOrHost: unknown): PhysicsNode | undefined {
    let found: PhysicsNode | undefined;
    for (const node of this.#nodes)
      if ([node.name, node.host, node.id].includes(nameOrHost)) found = node;
    return found;
  }

  get nodes(): Iterable<PhysicsNode> {
    return this.#nodes;
  }

  forget(node: PhysicsNode): void {
    this.#nodes.delete(node);
    this.#collections.delete(node as CollectionNode);
    this.#edits.drop(node);
    this.#problems.settle(node.host);
  }

  /** Settings of the world: its first collection's, or X3D's defaults. */
  get settings(): CollectionNode {
    for (const collection of this.#collections) return collection;
    return this.#defaults;
  }

  /** The world is its first RigidBodyCollection. */
  get(field: string): unknown {
    return this.settings.get(field);
  }

  set(field: string, value: unknown): void {
    if (this.#collections.size === 0) this.add('RigidBodyCollection');
    this.settings.set(field, value);
  }

  bodyAt(pointer: number): BodyNode | undefined {
    return this.bodies.behind(pointer);
  }

  // ---- edits ----------------------------------------------------------------------------------------------------

  enqueue(node: PhysicsNode): void {
    if (node === this.#defaults) return;
    this.#edits.add(node);
    this.work();
  }

  work(): void {
    this.onwork?.();
  }

  /** Applies pending edits. */
  flush(): void {
    if (this.started) this.#edits.applyAll(this.#apply);
  }

  readonly #apply = (node: PhysicsNode): void => {
    try {
      if (!node.built && this.engine.heapBytes > this.#heapLimit)
        throw new Error('the heap limit is reached');
      node.apply();
    } catch (error) {
      this.#exhausted(node, error);
    }
  };

  /** Bytes that the wasm heap may take. */
  get #heapLimit(): number {
    const { settings } = this;
    return settings.authored('heapLimit')
      ? settings.asked<number>('heapLimit') * 2 ** 20
      : this.#maxHeapBytes;
  }

  /** The heap is full, or Bullet gave up: the addition is undone and the world pauses; the page lives. */
  #exhausted(node: PhysicsNode, error: unknown): void {
    this.#paused = true;
    this.report(
      {
        code: 'heap-exhausted',
        severity: 'error',
        used: 'paused world',
        message: `${node.label} could not be made (${String(error)}); the world pauses`,
      },
      node,
    );
  }

  // ---- start, reset, end ------------------------------------------------------------------------------------------

  /** Builds everything added so far, in order, and settles `ready`. */
  start(engine: Engine): void {
    if (this.started) return;
    this.engine = engine;
    this.#build();
    this.flush();
    this.#settleReady.resolve(this);
    this.#emitter.emit('ready', this);
    this.work();
  }

  /** The world can't start: `ready` rejects with the problem. */
  fail(problem: unknown): void {
    this.#settleReady.reject(problem);
  }

  #build(): void {
    this.bullet = new BulletWorld(this.engine);
    this.started = true;
    this.#first = true;
    if (!this.engine.heapTrusted) this.#reportUnknownBuild();
    this.configure();
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
    this.#unbuild();
    this.#steps = this.#timeBefore = 0;
    this.#clock.reset();
    this.#build();
    for (const node of this.#nodes) {
      node.forgetEvents();
      this.enqueue(node);
    }
    this.flush();
    this.#emitter.emit('reset', this);
  }

  /** Newest first: joints before the bodies they hold. */
  #unbuild(): void {
    const nodes = [...this.#nodes].toReversed();
    for (let rank = RANKS - 1; rank >= 0; rank--) {
      for (const node of nodes) if (node.type.rank === rank) node.unmake();
    }
    this.bullet.dispose();
    this.started = false;
  }

  destroy(): void {
    if (this.started) this.#unbuild();
    for (const node of [...this.#nodes]) node.remove();
    this.#nodes.clear();
  }

  // ---- accuracy ---------------------------------------------------------------------------------------------------

  /** The level in force. */
  get accuracy(): LevelName {
    return this.#level.name;
  }

  set accuracy(name: LevelName) {
    this.set('accuracy', name);
    this.flush();
  }

  /** The ladder; `active` marks the level in force. */
  get levels(): (Level & { active: boolean })[] {
    return levels.map((level) => ({ ...level, active: level.name === this.#level.name }));
  }

  /** Seconds of one step. */
  get timeStep(): number {
    return this.#level.timeStep;
  }

  get solver(): JointSettings {
    return this.#solver;
  }

  /** Takes the settings of the first collection into Bullet. */
  configure(): void {
    if (!this.started) return;
    const { settings } = this;
    this.#setLevel(levelOf(settings));
    this.#enabled = settings.asked('enabled');
    this.configureSolver();
    for (const collection of this.#collections) collection.compareWith(settings);
    for (const node of this.#nodes) if (node instanceof JointNode) node.updateCorrection();
    this.work();
  }

  #setLevel(level: Level): void {
    if (level === this.#level) return;
    this.#timeBefore = this.time;
    this.#steps = 0;
    this.#level = level;
  }

  /** What Bullet's solver works with now. */
  configureSolver(): void {
    const { settings } = this;
    this.#solver = jointSettings(settings, this.#level);
    this.bullet.configure(solverSettings(settings, this.#level, this.registry.surface.anyBounce));
  }

  // ---- time -----------------------------------------------------------------------------------------------------

  get paused(): boolean {
    return this.#paused;
  }

  set paused(paused: boolean) {
    this.#paused = paused;
    this.work();
  }

  /** Simulated seconds since the start or the last reset. */
  get time(): number {
    return this.#timeBefore + this.#steps * this.timeStep;
  }

  /** Simulated seconds per second of the clock; 0 stands still. */
  get timeScale(): number {
    return this.#timeScale;
  }

  set timeScale(scale: number) {
    if (!(scale >= 0 && Number.isFinite(scale))) {
      this.report({
        code: 'bad-value',
        severity: 'warning',
        attribute: 'timeScale',
        value: scale,
        used: this.#timeScale,
        message: `timeScale takes a number from 0 on, not ${scale}; ${this.#timeScale} is used`,
      });
      return;
    }
    this.#timeScale = scale;
    this.work();
  }

  /**
   * Advances n steps at once, paused or not; returns the seconds advanced. `step(0)` applies pending edits. Within a
   * step (a `beforestep` listener) it does nothing.
   */
  step(n = 1): number {
    if (!this.started || this.#stepping) return 0;
    const steps = Math.max(0, Math.floor(n) || 0);
    this.#ms.step = this.#ms.read = this.#ms.events = 0;
    this.flush();
    for (let i = 0; i < steps && this.started; i++) this.#stepOnce();
    return steps * this.timeStep;
  }

  /** Advances by as many whole steps as come nearest to `seconds`. */
  advance(seconds: number): number {
    // A pending edit may change the level, and with it the length of a step.
    this.flush();
    return this.step(Math.round(seconds / this.timeStep));
  }

  #stepOnce(): void {
    this.#stepping = true;
    try {
      this.#event('beforestep');
      if (this.started) this.#stepAwake();
      this.#event('afterstep');
    } finally {
      this.#stepping = false;
    }
  }

  /** Where nothing is awake, only time goes on. */
  #stepAwake(): void {
    this.flush();
    if (this.bodies.awake > 0 || this.bodies.countAwake() > 0) {
      this.poses.shift();
      this.#stepBullet();
    }
    this.#steps++;
  }

  #stepBullet(): void {
    const start = performance.now();
    const { registry, timeStep } = this;
    registry.beforeStep(timeStep);
    this.engine.contacts.listen(
      this.bullet.bullet,
      // It writes into the heap, which only a known layout allows.
      registry.surface.active && this.engine.heapTrusted ? registry.surface : null,
    );
    this.bullet.step(timeStep);
    if (this.#first) reportOverlaps(this);
    this.#first = false;
    const stepped = performance.now();
    this.bodies.read();
    this.#ms.read += performance.now() - stepped;
    registry.afterStep(timeStep);
    this.#ms.step += performance.now() - start;
  }

  #event(name: 'beforestep' | 'afterstep'): void {
    if (!this.#emitter.heard(name)) return;
    const start = performance.now();
    this.#emitter.emit(name, { time: this.time, timeStep: this.timeStep });
    this.#ms.events += performance.now() - start;
  }

  /** Advances by wall time in fixed steps and places what is drawn between the last two. Returns `needsFrame`. */
  frame(seconds: number): boolean {
    if (!this.started) return false;
    this.#ms.step = this.#ms.read = this.#ms.events = 0;
    this.flush();
    if (this.running) this.#run(seconds * this.timeScale);
    this.poses.interpolate(this.#moving ? this.#clock.fraction(this.timeStep) : 1);
    return this.needsFrame;
  }

  #run(seconds: number): void {
    const { steps, dropped } = this.#clock.advance(seconds, this.timeStep);
    const start = performance.now();
    let done = 0;
    while (done < steps && (done === 0 || performance.now() - start < FRAME_BUDGET)) {
      this.#stepOnce();
      done++;
    }
    const lost = dropped + (steps - done) * this.timeStep;
    if (lost > 0) this.#lag(lost);
    this.#watchHeap();
  }

  #lag(seconds: number): void {
    this.#emitter.emit('lag', { dropped: seconds, time: this.time });
    this.#lost += seconds;
    if (this.#lost < MUCH_LOST) return;
    this.report({
      code: 'lag',
      severity: 'info',
      used: 'dropped time',
      message: 'the simulation could not keep up with the clock; the time it lost is dropped',
    });
  }

  #watchHeap(): void {
    if (this.engine.heapBytes < this.#heapLimit * HEAP_LOW) return;
    this.report({
      code: 'heap-low',
      severity: 'warning',
      value: this.engine.heapBytes,
      message: `the wasm heap has taken ${Math.round(this.engine.heapBytes / 2 ** 20)} MB of the ${Math.round(this.#heapLimit / 2 ** 20)} MB it may`,
    });
  }

  /** Whether time passes by itself. */
  get running(): boolean {
    return this.started && !this.#paused && this.#enabled && this.timeScale > 0;
  }

  get #moving(): boolean {
    return this.running && this.bodies.awake > 0;
  }

  /** Whether the next frame has anything to do. */
  get needsFrame(): boolean {
    return this.started && (this.#moving || this.#edits.pending);
  }

  // ---- what bodies ask of it --------------------------------------------------------------------------------------

  push(body: BodyNode, force: Vec3, torque: Vec3): void {
    this.registry.forces.push(body, force, torque);
  }

  contactParametersChanged(body: BodyNode): void {
    if (body.built) this.registry.surface.update(body);
  }

  /** Wakes what touches a body that goes or jumps: it may have lost its support. */
  wakeTouching(body: BodyNode): void {
    if (this.bodies.awake === this.bodies.count) return;
    this.bullet.eachManifold((manifold, a, b) => {
      if (manifold.getNumContacts() === 0 || (a !== body.pointer && b !== body.pointer)) return;
      const other = this.bodyAt(a === body.pointer ? b : a);
      if (other) other.wake();
    });
  }

  // ---- looking in -------------------------------------------------------------------------------------------------

  get stats(): Stats {
    let joints = 0;
    for (const node of this.#nodes) if (node instanceof JointNode && node.attached) joints++;
    return {
      bodies: this.bodies.count,
      awake: this.bodies.countAwake(),
      joints,
      contacts: this.#contacts(),
      ...this.counts,
      heapBytes: this.engine?.heapBytes ?? 0,
      ms: { ...this.#ms },
    };
  }

  #contacts(): number {
    let contacts = 0;
    if (this.started)
      this.bullet.eachManifold((manifold) => (contacts += manifold.getNumContacts()));
    return contacts;
  }

  get effects(): EffectReport[] {
    return this.registry.report();
  }

  get problems(): Problem[] {
    return this.#problems.all;
  }

  report(report: ProblemReport, about?: PhysicsNode | unknown): void {
    this.#problems.report(about instanceof PhysicsNode ? about.host : (about ?? this), report);
  }

  settle(about: PhysicsNode | unknown, attribute?: string, code?: string): void {
    this.#problems.settle(about instanceof PhysicsNode ? about.host : about, attribute, code);
  }

  problemsOf(about: PhysicsNode | unknown): Problem[] {
    return this.#problems.of(about instanceof PhysicsNode ? about.host : about);
  }

  on(event: string, listener: Listener): () => void {
    return this.#emitter.on(event, listener);
  }

  /** Milliseconds the page took to write poses; for `stats`. */
  noteWriteTime(ms: number): void {
    this.#ms.write = ms;
  }
}
