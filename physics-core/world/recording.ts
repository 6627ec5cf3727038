import { Chunk } from '../base/chunk.js';
import type { LevelName } from '../dynamics/levels.js';
import type { Snapshot } from './snapshot/snapshot.js';
import type { Watching } from './measuring.js';
import type { StepRecorder } from './stepping/step-recorder.js';
import type { World } from './world.js';

export interface RecordOptions {
  /** Simulated seconds that are kept, 10 by default; what is older goes. */
  seconds?: number;
}

/** The world at the end of a step, as one number. */
export interface StepHash {
  /** Steps since the recording began. */
  step: number;
  /** Simulated seconds. */
  time: number;
  /** Of the poses and velocities of all bodies, to the bit: 8 hexadecimal digits, the same in every browser. */
  hash: string;
}

/** Something that was done to the world, or that it told of. */
export interface TimelineMark {
  /** Simulated seconds. */
  time: number;
  /** For people. */
  text: string;
}

/**
 * What a world did, while `world.record()` keeps it. Looking back shows where bodies were; it simulates nothing, and what was
 * recorded of the future stays until `world.resume()`, a step or a drag goes on from there.
 */
export interface Timeline {
  /** Simulated seconds of the first picture that is kept, and of the last. There are 60 a second. */
  readonly from: number;
  readonly to: number;
  /** Where one looks, simulated seconds; undefined: at the running world. */
  readonly at: number | undefined;
  /** Whether what was recorded is being shown. */
  readonly playing: boolean;
  /** One in each 60 steps. */
  readonly hashes: readonly StepHash[];
  /** What was done meanwhile, and problems. */
  readonly marks: readonly TimelineMark[];
  /** Shows the picture that is nearest to a time, simulated seconds: `position` and `orientation` of bodies are those then. */
  seek(time: number): void;
  /** In a page: shows what was recorded, by the clock, from where one looks; from the beginning where that is the end. */
  play(): void;
  /** Stops there. */
  pause(): void;
  /**
   * Runs what was recorded anew at another level, from its beginning on, beside the world and in slices. From then on a ghost
   * of each body that moves is drawn as an outline while one looks at a moment: where the run at that level has it then. What
   * was done is done at the same time there; forces for a step keep their impulse. Settles when all of it was run; a later
   * call takes the place of this one, which then settles at once, and where the signal aborts it, it rejects and no ghost is
   * left. What is recorded later is run the next time one looks. Without a level the ghost is taken away.
   * @example
   * await timeline.ghost('fine');
   * timeline.seek(world.time - 3);
   * timeline.apart;                        // 0.12: a body is 12 cm from where `fine` has it
   */
  ghost(level?: LevelName, watching?: Watching): Promise<void>;
  /** The level of the ghost that there is, or that is on its way; undefined: none was asked for. */
  readonly ghostLevel: LevelName | undefined;
  /**
   * The greatest distance of a body from its ghost at the moment where one looks, metres; of bodies that only one of the two
   * runs has it is not asked. Undefined: there is no ghost of that moment, or nobody looks.
   */
  readonly apart: number | undefined;
  /** Keeps nothing any more, and forgets what it kept. A world at which nobody looks is as it was. */
  stop(): void;
}

/** Somebody did something by a method: of the world, of a node by its number, of a drag by its own. */
export interface Call {
  /** Steps that came before, since the recording began. */
  step: number;
  node?: number;
  drag?: number;
  method: string;
  args: unknown[];
  /** The number that the next node got. */
  next: number;
  /** Whether it came between steps by hand; else between frames. */
  singly: boolean;
}

/** A drag that was under way: its number, its body, and where it was held. */
export interface HeldDrag {
  drag: number;
  body: number;
  point: number[];
}

/** What `exportRun` writes. */
export const RUN_FORMAT = 1;

/** A run as plain data: where it began, what was done to it, and the hashes by which whoever runs it anew sees that it is the same. */
export interface Run {
  x3dPhysicsRun: typeof RUN_FORMAT;
  /** In a page: the markup of its `<scene>` as it is now. */
  markup?: string | undefined;
  start: Snapshot;
  drags: HeldDrag[];
  steps: number;
  calls: Call[];
  hashes: StepHash[];
}

/** What follows a world while it is recorded. */
export interface Recorder extends Timeline, StepRecorder {
  /** Simulated seconds that are kept. */
  readonly seconds: number;
  /** A method is called from outside. */
  keep<T>(who: object, method: string, args: readonly unknown[], work: () => T): T;
  /** Of where one looks. */
  snapshot(): Snapshot;
  /**
   * Says where the ghost has each body, and where the run has it, at the moment where one looks; both seen from Bullet's
   * origin. False: there is no ghost of that moment.
   */
  eachGhost(put: (id: number, pose: Float32Array, own: Float32Array) => void): boolean;
  exportRun(): Run;
}

/** Code of its own, in a room above that of worlds. */
interface RecordingCode {
  record(world: World, options: RecordOptions): Promise<Timeline>;
  /** What it needs is here: that of dense snapshots. */
  begin(world: World, seconds: number): Timeline;
  importRun(world: World, run: Run, watching: Watching): Promise<Timeline | undefined>;
}

export const recordings = new Chunk<RecordingCode>({ name: 'timeline', causes: 'world.record' });
