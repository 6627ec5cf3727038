import type { FrameCost } from './in-page/frames.js';
import type { Seen } from './in-page/probe.js';

/** Which library in which kind of page, and where that lies. */
export type PageAt = readonly [side: string, address: string];

interface Questions {
  /** What script costs: steady frames in which nothing is drawn, of several pages in turns. */
  script: { pages: readonly PageAt[]; warmUp: number; turns: number; frames: number; most: number };
  /** What a visitor gets. */
  frames: { page: PageAt; warmUp: number; seconds: number };
  /** How late an edit is seen: steady frames, each of which has what other threads answer to the one before. */
  edits: { page: PageAt; warmUp: number; frames: number };
  /** Which frames the page's own thread keeps, and how late an edit is seen; alone: nothing is simulated. */
  kept: { page: PageAt; warmUp: number; seconds: number; alone: boolean };
  /** How soon something moves. */
  start: { page: PageAt };
}

/** What the driver in a browser is asked for. */
export type Asked<Kind extends keyof Questions = keyof Questions> = {
  [K in Kind]: { kind: K } & Questions[K];
}[Kind];

export interface ScriptFound {
  /** Each turn's mean; a side is missing whose frames took too long. */
  sides: Record<string, FrameCost[]>;
  /** Where the first thing was by then, metres: the scenes are the same. */
  heights: Record<string, number | null>;
  /** How many things lived by then, where the library knows. */
  counts: Record<string, number | null>;
}

export interface FramesFound {
  frames: FrameCost[];
}

export interface EditsFound {
  seen: Seen[];
}

export interface KeptFound extends EditsFound {
  frames: FrameCost[];
}

export interface StartFound {
  ms: number;
}

export type Found =
  ScriptFound | FramesFound | EditsFound | KeptFound | StartFound | { failed: string };
