import type { Watching } from '../world/measuring.js';

/** Milliseconds of work at once: between two slices the page has its turn. */
const SLICE = 4;

/** Milliseconds after which a page that is never idle gives a slice all the same. */
const PATIENCE = 100;

/** Does a piece of work on this thread, in slices so short that no frame is dropped for them. */
export async function inSlices<T>(
  work: Generator<number, T>,
  { onprogress, signal }: Watching,
): Promise<T> {
  for (;;) {
    await pause();
    signal?.throwIfAborted();
    const end = performance.now() + SLICE;
    let next = work.next();
    while (!next.done && performance.now() < end) next = work.next();
    if (next.done) return next.value;
    onprogress?.(next.value);
  }
}

/** Until the page has nothing else to do; where nobody knows when that is, until everybody else had a turn. */
const pause = (): Promise<unknown> =>
  new Promise((resolve) => {
    if ('requestIdleCallback' in globalThis) requestIdleCallback(resolve, { timeout: PATIENCE });
    else setTimeout(resolve);
  });
