// Where measurements run so that the page's frames don't: the file accuracy-worker.js.
import { chunks } from '../world/chunks/all.js';
import { loadEngine } from '../engine/engine.js';
import type { Measured } from '../world/measuring.js';
import { Measurement, type Job } from './measurement.js';

/** What the page sends. */
export interface Order {
  job: Job;
  program: WebAssembly.Module | undefined;
}

/** What it hears. */
export type Answer =
  { ready: true } | { done: number } | { measured: Measured[] } | { failed: string };

/** Milliseconds between two words on how far it is. */
const PACE = 50;

const answer = (message: Answer): void => postMessage(message);

function measure(work: Generator<number, Measured[]>): Measured[] {
  let told = performance.now();
  for (;;) {
    const next = work.next();
    if (next.done) return next.value;
    if (performance.now() < told + PACE) continue;
    told = performance.now();
    answer({ done: next.value });
  }
}

addEventListener('message', async ({ data: { job, program } }: MessageEvent<Order>) => {
  try {
    const code = chunks.map((chunk) => chunk.load());
    const [engine] = await Promise.all([loadEngine({ program }), ...code]);
    answer({ measured: measure(new Measurement(job, engine).run()) });
  } catch (error) {
    answer({ failed: String(error) });
  }
});

answer({ ready: true });
