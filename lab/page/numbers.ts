import { readFileSync, writeFileSync } from 'node:fs';
import type { Estimate } from '../statistics.js';

/** Milliseconds of script per frame of one page: medians of turns. */
export interface ScriptCost {
  script: Estimate;
  physics: Estimate;
  drawing: Estimate;
  /** Where the first thing was at the end, metres. */
  height: number | null;
  /** Our script to this one's, turn by turn. */
  ours?: Estimate;
}

/** What a visitor sees: medians of frames. */
export interface FrameRate {
  perSecond: number;
  script: number;
  physics: number;
}

/** One scene of one size in one browser; what could not be measured says why. */
export interface PageCell {
  scene: string;
  count: number;
  script: Record<string, ScriptCost | string>;
  frames: Record<string, FrameRate | string>;
}

export interface BrowserPages {
  version: string;
  machine: string;
  date: string;
  cells: PageCell[];
  /** Milliseconds to the first frame in which something has moved. */
  start: Record<string, Estimate | string>;
}

export interface PageNumbers {
  /** Steady frames before anything is measured, turns, and frames of each. */
  warmUp: number;
  turns: number;
  frames: number;
  browsers: Record<string, BrowserPages>;
}

const FILE = new URL('../report/pages.json', import.meta.url);

export const readPages = (): PageNumbers => JSON.parse(readFileSync(FILE, 'utf8')) as PageNumbers;

export const writePages = (numbers: PageNumbers): void =>
  writeFileSync(FILE, `${JSON.stringify(numbers, null, 1)}\n`);
