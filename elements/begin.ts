import { page, yieldsToFirst } from './bridge/index.js';
import { defineElements } from './define.js';

/** Both spellings of every node, from now on; where there is no page, importing does nothing. */
export function begin(): void {
  if (!globalThis.document || yieldsToFirst()) return;
  defineElements();
  page.begin();
}
