import { tellPage } from '../document/misplaced.js';

/** All copies of the library on a page, say the module and a classic script, work through the first one's. */
const KEY = Symbol.for('x3d-physics');

export function firstCopy<Page>(own: Page): Page {
  const shared = (globalThis.document ?? {}) as { [KEY]?: Page };
  return (shared[KEY] ??= own);
}

export function tellTwoCopies(): void {
  const report = {
    code: 'two-copies',
    severity: 'warning' as const,
    used: 'the first copy',
    message:
      'x3d-physics is in this page twice, say as a module and as a classic script; the first copy does all the work, the second only costs its bytes',
  };
  tellPage(report, document.documentElement);
}
