import type { Measured, Watching } from '../world/measuring.js';
import { loadedWorker } from '../world/worker.js';
import { NAME, type Answer, type Order } from './orders.js';

/** Measures in a worker. Undefined: the page allows none (its security policy, opened from disk), or there is no file for it. */
export async function inWorker(
  order: Order,
  workerUrl: string | URL | undefined,
  watching: Watching,
): Promise<Measured[] | undefined> {
  const worker = await loadedWorker(workerUrl, NAME).catch(() => undefined);
  if (!worker) return undefined;
  try {
    return await answered(worker, order, watching);
  } finally {
    worker.terminate();
  }
}

function answered(
  worker: Worker,
  order: Order,
  { onprogress, signal }: Watching,
): Promise<Measured[]> {
  return new Promise((resolve, reject) => {
    const abort = (): void => reject(signal!.reason);
    if (signal?.aborted) return abort();
    signal?.addEventListener('abort', abort);
    worker.onmessage = ({ data }: MessageEvent<Answer>) => {
      if ('done' in data) onprogress?.(data.done);
      if ('measured' in data) resolve(data.measured);
      if ('failed' in data) reject(new Error(data.failed));
    };
    worker.postMessage(order);
  });
}
