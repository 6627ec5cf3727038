import type { EventQueue } from '../base/event-queue.js';
import type { ProblemReport } from '../base/problems.js';
import type { BulletWorld } from '../engine/bullet-world.js';
import type { Engine } from '../engine/engine.js';
import type { Bodies } from './bodies.js';
import type { Body } from './body.js';
import type { Pairs } from './pairs.js';
import type { Poses } from './poses.js';

/** The running world as effects see it: Bullet, what moves in it, and who collides with whom. */
export interface Simulation {
  readonly engine: Engine;
  readonly bullet: BulletWorld;
  readonly poses: Poses;
  readonly bodies: Bodies;
  readonly pairs: Pairs;
  readonly events: EventQueue;
  /** Simulated seconds. */
  readonly time: number;
  /** Seconds of one step. */
  readonly timeStep: number;
  /** Seconds of one step of Bullet: a part of `timeStep` where something turns too far for one. */
  readonly partOfStep: number;
  /** Steps of Bullet so far, whatever became of time. */
  readonly stepsTaken: number;
  readonly stepping: {
    /** Seconds that pass before an author has the next word: one step, or where frames drive the world one of them. */
    readonly turn: number;
  };
  /** The body behind a heap pointer that Bullet hands us. */
  bodyAt(pointer: number): Body | undefined;
  /** Bullet's solver is to work with what contacts demand now. */
  configureSolver(): void;
  /** There is something to do for whoever drives the world. */
  work(): void;
  emit(event: string, detail: unknown): void;
  report(report: ProblemReport, about?: unknown): void;
}
