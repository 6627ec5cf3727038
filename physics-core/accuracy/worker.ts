// Where measurements run so that the page's frames don't: a classic script, which is whole by itself, as a worker.
import { wholeCode } from '../world/whole-code.js';
import { loadEngine } from '../engine/engine.js';
import type { Measured } from '../world/measuring.js';
import { isWorkerNamed } from '../world/worker.js';
import { Measurement } from './measurement.js';
import { NAME, type Answer, type Order } from './orders.js';

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

async function take({ data: { job, program } }: MessageEvent<Order>): Promise<void> {
  try {
    const code = wholeCode.map((chunk) => chunk.load());
    const [engine] = await Promise.all([loadEngine({ program }), ...code]);
    answer({ measured: measure(new Measurement(job, engine).run()) });
  } catch (error) {
    answer({ failed: String(error) });
  }
}

/** Whether this is that worker. */
export const isMeasuring = (): boolean => isWorkerNamed(NAME);

export function takeOrders(): void {
  addEventListener('message', (event: MessageEvent<Order>) => void take(event));
  answer({ ready: true });
}
