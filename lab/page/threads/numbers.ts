import { readFileSync, writeFileSync } from 'node:fs';
import type { Estimate } from '../../statistics.js';

/** Milliseconds of frames: their median, and what 95 of 100 do not exceed. */
export interface Spread extends Estimate {
  most: number;
}

/** How late edits are seen. */
export interface Late {
  edits: number;
  /** Which frame after the edit is the first that shows it. */
  frame: { median: number; most: number };
  /** How far that is behind the edit, milliseconds. */
  behind: { median: number; most: number };
}

/** What one way costs the page's own thread. */
export interface ThreadSide {
  /** All of our script but what x3dom's own frame takes. */
  own: Spread;
  drawing: Spread;
  /** Of the frames that there was time for, the share that came. */
  kept: number;
  /** Where a worker answers within a frame, and in the frames of this browser. */
  steady: Late;
  late: Late;
}

/** Scene 3 with so many boxes. */
export interface ThreadCell {
  count: number;
  date: string;
  /** Processes that ran or waited while it was measured. */
  load: number;
  main: ThreadSide;
  worker: ThreadSide;
  /** Our script on the page's thread with a worker to that without, frame by frame. */
  ratio: Estimate;
  /** Frames that drawing alone keeps: the same motion, played back. */
  alone: number;
}

export interface BrowserThreads {
  version: string;
  machine: string;
  cells: ThreadCell[];
}

export interface ThreadNumbers {
  /** Frames before anything is measured, and those that are. */
  warmUp: number;
  frames: number;
  browsers: Record<string, BrowserThreads>;
}

const FILE = new URL('../../report/threads.json', import.meta.url);

export const readThreads = (): ThreadNumbers =>
  JSON.parse(readFileSync(FILE, 'utf8')) as ThreadNumbers;

export const writeThreads = (numbers: ThreadNumbers): void =>
  writeFileSync(FILE, `${JSON.stringify(numbers, null, 1)}\n`);
