import { loadBullet } from '../../../physics-core/inside.js';

export type Engine = Awaited<ReturnType<typeof loadBullet>>;

let attempt: Promise<Engine> | undefined;
/** Those who were told that it can't be had: they take part in the next attempt. */
const told = new Set<() => void>();

/**
 * The engine, fetched once per page when the first physics element appears. An attempt that failed is not the last one:
 * the next follows when another world is made or the browser is online again.
 */
export function engine(): Promise<Engine> {
  if (attempt && told.size === 0) return attempt;
  attempt = loadBullet();
  const again = [...told];
  told.clear();
  for (const load of again) load();
  return attempt;
}

/** Begins fetching while the rest of the page is still read. */
export function prefetchEngine(): void {
  if (!attempt) engine().catch(() => {});
}

/** `load` was told that it can't be had, and takes part in the next attempt. */
export function awaitAttempt(load: () => void): void {
  told.add(load);
  window.addEventListener('online', tryAgain);
}

export function stopAwaiting(load: () => void): void {
  told.delete(load);
}

function tryAgain(): void {
  if (told.size > 0) engine().catch(() => {});
}
