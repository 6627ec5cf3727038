// What a cell of the stability matrix judges: one hard case, at one level.
import type { CreateOptions } from '../../physics-core/create.js';
import type { LevelName, World } from '../../physics-core/inside.js';
import type { Told } from './told.js';

/** A case that plays in a world. */
export interface Play {
  /** What its author does, so many seconds and frames of 1/60 s after the start, before time passes. */
  before?(seconds: number, frame: number): void;
  /** Lets a sixtieth of a second pass; some cases have clocks of their own. */
  pass?(): void;
  /** After each step. */
  after?(): void;
  /** The number that is judged, in the unit of the criterion. */
  measured(): number;
  /** What is worth knowing besides, and is not judged. */
  noted?(): Record<string, number>;
}

export interface Criterion {
  /** What is measured: `widest gap, of a link`. */
  what: string;
  unit: string;
  /** The cell breaks above it. */
  most: number;
}

/** What makes it hard, and by how much: masses 1:100 are `{ of: 'masses', ratio: 100 }`. */
export interface Load {
  of: string;
  ratio: number;
}

export interface StabilityCase {
  /** S1 to S31, or a word. */
  id: string;
  /** A sentence: what holds. */
  says: string;
  load?: Load;
  /** Simulated. */
  seconds: number;
  /** In the place of seconds: as many steps at every level. */
  steps?: number;
  criterion: Criterion;
  /** The lowest level that promises it; all above it do, too. Null: none does, and why stands beside it. */
  promisedFrom: LevelName | null;
  /** Levels above it at which measurement refutes it; the number stands beside it. */
  refutedAt?: LevelName[];
  /** Levels that tests look at beside the lowest one. */
  alsoTested?: LevelName[];
  /** The finest level that is looked at, where finer ones only take longer. */
  finest?: LevelName;
  /** More than five seconds at its lowest level in Node: tests leave browsers alone with it, the lab does not. */
  slow?: boolean;
  /** Fields of the world beyond level and rest. */
  world?: CreateOptions;
  /** Why energy may grow: what puts work in. Without it none may come from nowhere. */
  work?: string;
  /** The lowest place that bodies may fall to, metres: what energy is counted from. */
  lowest?: number;
  /** Codes of problems that have to come. */
  tells?: string[];
  /** Codes of problems that may come. */
  mayTell?: string[];
  scene(world: World): Play;
  /** The scene in words that other engines have, too. */
  told?(): Told | undefined;
}

/** What a cell found. */
export interface Cell {
  holds: boolean;
  measured: number;
  /** What broke, where it is not the criterion. */
  why?: string;
  /** Hash of all poses in the end, of our own runs: the same wherever it runs. */
  bits?: string;
  /** What the case notes besides. */
  noted?: Record<string, number>;
}
