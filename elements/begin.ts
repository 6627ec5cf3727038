import { page } from './bridge/index.js';
import { defineElements } from './define.js';

/** Both spellings of every node, from now on; where there is no page, importing does nothing. */
export function begin(): void {
  if (!globalThis.document) return;
  defineElements();
  page.begin();
}
