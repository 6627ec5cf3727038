import type { CaseScene, Sight } from '../case.js';

/** What one run of an engine is set to. */
export interface Setting {
  /** One of our levels; without it a point of a sweep. */
  level?: string;
  /** Seconds of one step of the solver. */
  step: number;
  /** Of the solver per step. */
  iterations: number;
}

/** A scene in an engine. */
export interface Running extends Sight {
  /** Seconds that `step` takes the scene on. */
  readonly timeStep: number;
  step(): void;
  /** Contact points now; null where the engine does not tell. */
  contacts(): number | null;
  /** What the engine does for this scene beside its plain step. */
  effects(): string[];
  destroy(): void;
}

/** A physics engine as the lab runs it. */
export interface Engine {
  /** As in rows and file names. */
  id: string;
  name: string;
  /** How it is run here, in a sentence. */
  says: string;
  settings: readonly Setting[];
  /** Throws `NotOffered` where the engine has no words for the scene. */
  make(scene: CaseScene, setting: Setting): Promise<Running>;
}

/** The engine can't be told the scene; the message says what it lacks. */
export class NotOffered extends Error {}

/** Steps per second that engines are swept over. */
const RATES = [60, 120, 240, 480, 960, 1920];

/** All steps at each number of iterations. */
export const sweep = (iterations: readonly number[]): Setting[] =>
  iterations.flatMap((count) => RATES.map((rate) => ({ step: 1 / rate, iterations: count })));
