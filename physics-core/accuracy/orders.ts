// What a page and its worker say to each other.
import type { Measured } from '../world/measuring.js';
import type { Job } from './measurement.js';

/** What the worker is called, so that its script knows what it was started for. */
export const NAME = 'x3d-physics: accuracy';

/** What the page sends. */
export interface Order {
  job: Job;
  program: WebAssembly.Module | undefined;
}

/** What it hears. */
export type Answer =
  { ready: true } | { done: number } | { measured: Measured[] } | { failed: string };
