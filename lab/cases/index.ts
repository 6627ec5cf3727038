import type { Case } from '../case.js';

/** Every case of the lab, by its number. */
export const cases: readonly Case[] = [
  // One line per file of cases: ...name,
].sort((a: Case, b: Case) => a.id.localeCompare(b.id, 'en', { numeric: true }));
