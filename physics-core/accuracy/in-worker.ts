import type { Measured, Watching } from '../world/measuring.js';
import { NAME, type Answer, type Order } from './orders.js';

/** Milliseconds that a worker may take to load. */
const LATEST = 10_000;

/** Beside this file, where nobody says otherwise. One file with all that it needs: bundlers copy it as it is. */
const besides = (): string => new URL('./x3d-physics.classic.js', import.meta.url).href;

const OPTIONS: WorkerOptions = { type: 'module', name: NAME };

/** Measures in a worker. Undefined: the page allows none (its security policy, opened from disk), or there is no file for it. */
export async function inWorker(
  order: Order,
  workerUrl: string | URL | undefined,
  watching: Watching,
): Promise<Measured[] | undefined> {
  const worker = await loaded(workerUrl).catch(() => undefined);
  if (!worker) return undefined;
  try {
    return await answered(worker, order, watching);
  } finally {
    worker.terminate();
  }
}

/** Scripts of another server are only taken from within one of the page's own. */
function startWorker({ origin, href }: URL): Worker {
  if (origin === location.origin) return new Worker(href, OPTIONS);
  const source = new Blob([`import ${JSON.stringify(href)};`], { type: 'text/javascript' });
  const address = URL.createObjectURL(source);
  const worker = new Worker(address, OPTIONS);
  worker.addEventListener('message', () => URL.revokeObjectURL(address), { once: true });
  return worker;
}

/** A worker that answers. */
async function loaded(url: string | URL | undefined): Promise<Worker> {
  const worker = startWorker(new URL(url ?? besides(), location.href));
  await new Promise((resolve, reject) => {
    setTimeout(reject, LATEST);
    worker.onmessage = resolve;
    worker.onerror = (event) => {
      event.preventDefault();
      reject(new Error(event.message));
    };
  }).catch((error) => {
    worker.terminate();
    throw error;
  });
  return worker;
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
