// How a worker of this library is started: its script is one file with all that it needs.

/** Milliseconds that a worker may take to load. */
const LATEST = 10_000;

/** Beside this file, where nobody says otherwise. One file with all that it needs: bundlers copy it as it is. */
const besides = (): string => new URL('./x3d-physics.classic.js', import.meta.url).href;

/** Scripts of another server, and all in a sandbox, are only taken from within one of the page's own. */
function startWorker({ origin, href }: URL, name: string): Worker {
  const options: WorkerOptions = { type: 'module', name };
  if (origin === globalThis.origin) return new Worker(href, options);
  const source = new Blob([`import ${JSON.stringify(href)};`], { type: 'text/javascript' });
  const address = URL.createObjectURL(source);
  const worker = new Worker(address, options);
  worker.addEventListener('message', () => URL.revokeObjectURL(address), { once: true });
  return worker;
}

/** A worker that answers. Rejects where the page allows none (its security policy, opened from disk), or there is no file for it. */
export async function loadedWorker(url: string | URL | undefined, name: string): Promise<Worker> {
  const worker = startWorker(new URL(url ?? besides(), location.href), name);
  await new Promise((resolve, reject) => {
    setTimeout(() => reject(new Error('its script does not answer')), LATEST);
    worker.onmessage = resolve;
    worker.onerror = (event) => {
      event.preventDefault();
      reject(new Error(event.message ?? 'its script can’t be loaded'));
    };
  }).catch((error) => {
    worker.terminate();
    throw error;
  });
  return worker;
}

/** Whether this is a worker that was started so, by this name, and no page, and none of a page's own. */
export function isWorkerNamed(expected: string): boolean {
  const { document, name } = globalThis as { document?: unknown; name?: unknown };
  return !document && name === expected;
}
