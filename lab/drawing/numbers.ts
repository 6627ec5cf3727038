import { readFileSync, writeFileSync } from 'node:fs';
import type { Way } from './in-page/turns.js';
import type { RoomFrames } from './in-page/room.js';

/** Milliseconds of script per frame, calls of WebGL per frame. */
export interface Cost {
  ms: number;
  calls: number;
}

export interface Row extends Record<Way, Cost> {
  bodies: number;
  /** Nothing behind it, so that script alone is measured, or drawn without a graphics card. */
  webgl: 'none' | 'software';
}

/** Scene 3 of the paper with so many boxes. */
export interface RoomRow extends Record<'plain' | 'batched', RoomFrames> {
  boxes: number;
}

export interface DrawingNumbers {
  /** When, on what, and how busy that was: of each part. */
  measured: Record<string, string>;
  rows: Row[];
  /** Milliseconds of one change among so many bodies. */
  edits: { bodies: number; ms: Record<string, number> }[];
  room: RoomRow[];
}

const FILE = new URL('../report/drawing.json', import.meta.url);

export const readDrawing = (): DrawingNumbers =>
  JSON.parse(readFileSync(FILE, 'utf8')) as DrawingNumbers;

export const writeDrawing = (numbers: DrawingNumbers): void =>
  writeFileSync(FILE, `${JSON.stringify(numbers, null, 2)}\n`);
