// The chunk `debug`.
import { legend } from './debug/colors.js';
import { DebugLines } from './debug/debug-lines.js';
import type { outlines } from './debug/debugging.js';

export const provide = (): typeof outlines.code => ({
  lines: (simulation, scene) => new DebugLines(simulation, scene),
  legend,
});
