import type { FramePace } from './pace.js';

/** What a frame's milliseconds are split by: Bullet and effects, reading poses, writing them to the page, listeners. */
export const PHASES = ['step', 'read', 'write', 'events'] as const;
export type Phase = (typeof PHASES)[number];

/** Milliseconds that so many of a hundred frames stayed below. */
export interface Percentiles {
  p50: number;
  p90: number;
  p99: number;
}

/** Of the frames of the last seconds that took a step. */
export interface Costs extends Record<Phase | 'total', Percentiles> {
  frames: number;
  /** How frames follow each other, those without a step included; undefined before a second frame. */
  pace: FramePace | undefined;
}
