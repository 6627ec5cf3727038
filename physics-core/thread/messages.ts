// What a page and the worker of a world say to each other. Orders are numbered, and carried out one after the other.
import type { ProblemReport } from '../base/problems.js';
import type { EffectReport } from '../effects/effect/report.js';
import type { ToldDeformable } from '../effects/deformables/deformable.js';
import type { ToldRope } from '../effects/soft/rope.js';
import type { ToldSurface } from '../effects/water/moving-surface.js';
import type { Call, StepHash, TimelineMark } from '../world/recording.js';
import type { Snapshot } from '../world/snapshot/snapshot.js';
import type { Stats } from '../world/store/types.js';

/** What the worker is called, so that its script knows what it was started for. */
export const NAME = 'x3d-physics: world';

/** What the worker hears first: what it is to go on from. */
export interface Beginning {
  snapshot: Snapshot;
  program: WebAssembly.Module | undefined;
}

/** Somebody begins or ceases to listen to a node, by its number, or to the world. */
export interface Listening {
  node: number | undefined;
  event: string;
  heard: boolean;
}

/** A stretch of the clock. */
export interface Stretch {
  seconds: number;
  /** Whether somebody waits for its frame. */
  seen: boolean;
}

/** What somebody does to look at what is recorded there. */
export interface Look {
  method: 'seek' | 'play' | 'pause' | 'stop';
  args: number[];
}

/** What was done to the world, in order. */
export type Deed =
  { call: Call } | { listening: Listening } | { restore: Snapshot } | { look: Look };

/** What is answered in numbers of nodes, and stays so. */
export const PLAIN = ['snapshot', 'resume', 'exportRun'];

export interface Rooms {
  states: Float64Array<ArrayBuffer>;
  clouds: Float64Array<ArrayBuffer>;
}

export interface Order {
  number: number;
  deeds: Deed[];
  /** What passed on the clock since; none: nothing does. */
  stretches: Stretch[];
  paused: boolean;
  timeScale: number;
  /** Whether somebody reads what effects cost. */
  watched: boolean;
  /** Whether somebody draws contact points. */
  marked: boolean;
  /** Whether somebody asked what was done while it was recorded. */
  remembered: boolean;
  ask?: { method: string; args: unknown[] } | undefined;
  /** Room for states and clouds, handed to and fro. */
  rooms?: Rooms | undefined;
}

/** Of whom the other thread speaks: a node by its number; undefined: the world. */
interface About {
  node: number | undefined;
}

/** What the other world told, in order. */
export type Said =
  | (About & { event: string; detail: unknown })
  | (About & { problem: ProblemReport })
  | (About & { settled: { attribute: string | undefined; code: string | undefined } });

/** What effects cost, by name. */
export type EffectCosts = Record<string, Pick<EffectReport, 'active' | 'ms' | 'calls'>>;

/** What is shown of a recording, as in `Timeline`. */
export interface Recorded {
  from: number;
  to: number;
  at: number | undefined;
  playing: boolean;
  /** Where they are others than in the answer before. */
  hashes?: readonly StepHash[] | undefined;
  /** Where they were asked for. */
  marks?: readonly TimelineMark[] | undefined;
}

export interface Answer extends Rooms {
  number: number;
  /** Bodies that moved: STATE numbers of each are the first of `states`. Those of `clouds` say how many they are. */
  count: number;
  /** Surfaces of water that are others now. */
  surfaces: ToldSurface[] | undefined;
  /** Ropes that have moved. */
  ropes: ToldRope[] | undefined;
  /** Cloth and soft bodies that have moved. */
  deformables: ToldDeformable[] | undefined;
  /** Where between the last two steps things are drawn. */
  fraction: number;
  time: number;
  taken: number;
  /** It paused of itself: it has no more memory. */
  stopped: boolean;
  /** Whether it needs another frame. */
  needsFrame: boolean;
  said: Said[];
  stats: Stats;
  effects?: EffectCosts | undefined;
  /** See `SeenContacts`. */
  contacts?: Float64Array | undefined;
  /** While it is recorded. */
  recorded?: Recorded | undefined;
  asked?: unknown;
}

/** What the worker says: that it is there, what came of an order, or that it can't go on. */
export type Message = { ready: true } | { answer: Answer } | { failed: string };

/**
 * Numbers of a body: its id, whether it sleeps, its poses at the last two steps, its velocities, and those that are shown: where
 * joints hold it they are of the end of the step, and the others of its middle.
 */
export const STATE = 28;

/** Where of those the shown ones begin. */
export const SHOWN = 22;
