import type { LevelMeasurement, MeasureOptions, Watching } from '../world/measuring.js';
import type { Problem } from '../base/problems.js';
import type { Level, LevelName } from '../dynamics/levels.js';
import type { Costs } from '../effects/costs/phases.js';
import type { ColorMeaning } from '../effects/debug/colors.js';
import type { EffectReport } from '../effects/effect/report.js';
import type { Vec3 } from '../fields/types.js';
import type { RecordOptions, Run, Timeline } from '../world/recording.js';
import type { Snapshot } from '../world/snapshot/snapshot.js';
import type { Stats } from '../world/store/types.js';
import type { WorldEvents } from './events.js';
import type { NodeFields, NodeName, NodeValues, RigidBodyCollectionFields } from './fields.js';
import type { Body, Node, NodeHandles, NodeOf, Vector } from './nodes.js';

/** The first thing on the way of a ray. */
export interface RayHit {
  /** The body; the collidable where that has none. */
  node: Node;
  /** The part of it that was hit. */
  collidable: Node;
  /** World frame, metres. */
  position: Vec3;
  /** Unit vector of the surface, towards where the ray came from. */
  normal: Vec3;
  /** Share of the way, 0 to 1. */
  fraction: number;
}

/** The surface of water on the way of a ray. */
export type SurfaceHit = Omit<RayHit, 'collidable'>;

export interface NodeOptions {
  /** Its DEF, by which `world.node` finds it. */
  name?: string;
  /** Which RigidBodyCollection a body belongs to, in a world with several. */
  collection?: NodeOf<'RigidBodyCollection'>;
}

/** What can be asked of a world on any thread: arguments and answer. */
export interface Answers {
  step: { args: [n?: number]; answer: number };
  advance: { args: [seconds: number]; answer: number };
  raycast: {
    args: [from: Vector, to: Vector, also?: { water?: boolean }];
    answer: RayHit | SurfaceHit | null;
  };
  snapshot: { args: []; answer: Snapshot };
  exportRun: { args: []; answer: Run | undefined };
  stats: { args: []; answer: Stats };
  effects: { args: []; answer: EffectReport[] };
  explain: { args: [node: unknown]; answer: unknown };
}

/** A world of X3D nodes. It is its first RigidBodyCollection, too: `get` and `set` are those of that node. */
export interface World {
  /** Settles when it has started, and always: it rejects with the problem where it can't. In the core it has. */
  readonly ready: Promise<World>;

  // ---- nodes ----------------------------------------------------------------------------------------------------

  /**
   * Adds a node of an X3D type, with values for its fields in SI units. Throws a TypeError for a type that there is not;
   * values that can't be used are reported in `problems`, and the defaults are used.
   */
  add<Name extends NodeName>(
    type: Name,
    fields?: NodeFields[Name],
    options?: NodeOptions,
  ): NodeHandles[Name];

  /** All its nodes, in the order in which they were added. */
  readonly nodes: Iterable<Node>;

  /** The node with this name (DEF, or id in a page) or number; the last one where several have the name. */
  node<Type extends Node = Body>(name: string | number | null | undefined): Type | undefined;

  /** A field of its first RigidBodyCollection. */
  get<Field extends keyof NodeValues['RigidBodyCollection']>(
    field: Field,
  ): NodeValues['RigidBodyCollection'][Field];

  /** Asks for a value of a field of its first RigidBodyCollection. */
  set<Field extends keyof RigidBodyCollectionFields>(
    field: Field,
    value: RigidBodyCollectionFields[Field],
  ): void;

  // ---- time -----------------------------------------------------------------------------------------------------

  /** Whether time stands still in a page; `step` and `advance` go on all the same. */
  paused: boolean;

  /** Simulated seconds per second of the clock, in a page; 1 by default, 0 stands still. */
  timeScale: number;

  /**
   * Simulated seconds since the start or the last reset. In a page it stands while nothing is awake, and while nobody sees
   * the scene, unless its field `runHidden` is TRUE; what begins again takes up no time that passed meanwhile.
   */
  readonly time: number;

  /** Seconds of one step at the present level: 1/120 at `standard`. */
  readonly timeStep: number;

  /**
   * Advances `n` steps (1 by default) at once, paused or not, and returns the seconds advanced. `step(0)` applies edits that
   * wait. Before the start, within a step, and in a page while the code of an effect is on its way (`waiting-for-effect`), it
   * does nothing and returns 0.
   */
  step(n?: number): number;

  /** Advances by as many whole steps as come nearest to so many seconds; returns the seconds advanced. */
  advance(seconds: number): number;

  /** Back to what the markup, or `add` and `set`, say, at time 0. The next n steps are the first n steps, bit for bit. */
  reset(): void;

  /** All that its next step reads, as plain data: to keep, clone or send. While one looks back, of where one looks. */
  snapshot(): Snapshot;

  /**
   * Back to a snapshot of this world: it runs on as it did then, bit for bit. What was not edited since is not made anew.
   * Anything else than a whole snapshot of this scene is reported, and nothing happens.
   */
  restore(snapshot: Snapshot): void;

  /**
   * Keeps what it does from now on, for so many simulated seconds: 60 pictures a second, what is done to it, and a snapshot
   * each second. Asked again it begins anew. `reset()` and `restore()` begin it anew, too. Settles when its code is here;
   * where that is, in the core always, it keeps the very next step. What runs in a worker is recorded there: `timeline` shows
   * the answer that came back last, `marks` those of the answer after they were last read.
   * @example
   * await world.record({ seconds: 20 });
   * // ... something falls over
   * world.timeline.seek(world.time - 3);
   * world.resume();                        // the last three seconds have not been
   */
  record(options?: RecordOptions): Promise<Timeline>;

  /** What was recorded; undefined: nothing is. */
  readonly timeline: Timeline | undefined;

  /**
   * Goes on from where one looks in the timeline: as if what came later had not been, bit for bit as it went from there if
   * the same is done to it. What was done while one looked is done now. Without a timeline, and at the running world, nothing.
   */
  resume(): void;

  /** What is recorded as plain data, for `importRun` in another page or browser; undefined: nothing is recorded. */
  exportRun(): Run | undefined;

  /**
   * Runs a run anew in this world, which has to have the same scene (an empty one gets its nodes): beside it and in pieces, so
   * that nothing stops. Then the world is where the run ended, and its timeline the run's. Where it goes another way than it
   * went, `run-diverged` tells the step, and it ends there. Undefined: it can't be read (`bad-value`).
   */
  importRun(run: Run, watching?: Watching): Promise<Timeline | undefined>;

  /** Ends it, and gives back its memory. */
  destroy(): void;

  // ---- accuracy -------------------------------------------------------------------------------------------------

  /** The level in force. Set to `auto` it is the finest that fits the field `timeBudget`. */
  get accuracy(): LevelName;
  set accuracy(level: LevelName | 'auto');

  /** The ladder, coarse to fine; `active` marks the level in force. */
  readonly levels: (Level & { active: boolean })[];

  /** What each level costs and leaves in this scene, from the state it is in; the running world notices nothing. */
  measureAccuracy(options?: MeasureOptions): Promise<LevelMeasurement[]>;

  // ---- looking in -----------------------------------------------------------------------------------------------

  /** The first thing on the way between two points (world frame, metres), or null. */
  raycast(from: Vector, to: Vector): RayHit | null;
  /** The same, and with `water` the surface of a WaterVolume, whichever comes first. */
  raycast(from: Vector, to: Vector, also: { water?: boolean }): RayHit | SurfaceHit | null;

  /** How much there is in it, seconds of the clock it dropped, and milliseconds of the last frame by phase. */
  readonly stats: Stats;

  /** What it does beyond plain falling bodies, because of what, and what that costs: in milliseconds, calls and bytes. */
  readonly effects: EffectReport[];

  /** What authors should know, each once, until it changes. */
  readonly problems: Problem[];

  /** Milliseconds of late frames by phase, and how frames follow each other, while `recordCosts` asks for them. */
  readonly costs: Costs | undefined;

  /** What the colours of the debug drawing mean; nothing while it is off. */
  readonly debugLegend: readonly ColorMeaning[];

  /**
   * Keeps what frames cost, for `costs`; `who` looks stands in `effects`. Returns how to stop. A page fetches the code of
   * that first.
   */
  recordCosts(who: unknown, reason?: string): () => void;

  /** Whether each phase stands on the browser's Performance panel (User Timing); false by default. A page fetches the code of that first. */
  profile: boolean;

  // ---- another thread -------------------------------------------------------------------------------------------

  /**
   * While its steps are taken in a worker (field `thread`): the step that came back last, counted from 0. Live values, `stats`
   * and `effects` are those of that step. Undefined: it runs on this thread, and they are those of the last step.
   */
  readonly mirrored: number | undefined;

  /**
   * Asks on whichever thread it runs, with the arguments of the method of that name: `step` and `advance` (seconds advanced),
   * `raycast`, `snapshot`, `exportRun`, `stats`, `effects`, and `explain` with a node (in a page: an element). Rejects where
   * the worker is lost or the world ends. In a worker `step`, `advance`, `raycast`, `snapshot` and `exportRun` themselves
   * report `asynchronous`, and return 0 or null.
   * @example
   * await world.ask('step', 60);
   * const hit = await world.ask('raycast', [0, 9, 0], [0, -9, 0]);
   */
  ask<Method extends keyof Answers>(
    method: Method,
    ...args: Answers[Method]['args']
  ): Promise<Answers[Method]['answer']>;

  /** Calls the listener with each event's detail until the function that is returned is called. */
  on<Event extends keyof WorldEvents>(
    event: Event,
    listener: (detail: WorldEvents[Event]) => void,
  ): () => void;
}
