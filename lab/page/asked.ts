import type { FrameCost } from './in-page/frames.js';

/** Which library in which kind of page, and where that lies. */
export type PageAt = readonly [side: string, address: string];

interface Questions {
  /** What script costs: steady frames in which nothing is drawn, of several pages in turns. */
  script: { pages: readonly PageAt[]; warmUp: number; turns: number; frames: number; most: number };
  /** What a visitor gets. */
  frames: { page: PageAt; warmUp: number; seconds: number };
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
}

export interface FramesFound {
  frames: FrameCost[];
}

export interface StartFound {
  ms: number;
}

export type Found = ScriptFound | FramesFound | StartFound | { failed: string };
