import { tellPage } from '../document/misplaced.js';
import { faultsFor } from '../words/faults.js';

/** All copies of the library on a page, say the module and a classic script, work through the first one's. */
const KEY = Symbol.for('x3d-physics');

export function firstCopy<Page>(own: Page): Page {
  const shared = (globalThis.document ?? {}) as { [KEY]?: Page };
  return (shared[KEY] ??= own);
}

export function tellTwoCopies(): void {
  const page = document.documentElement;
  const faults = faultsFor(page, tellTwoCopies);
  if (faults) tellPage(faults.twoCopies(), page);
}
