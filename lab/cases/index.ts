import type { Case } from '../case.js';

const number = ({ id }: Case): number => Number(id.slice(1));

/** Every case of the lab, by its number. */
export const cases: readonly Case[] = [
  // One line per file of cases: ...name,
].sort((a: Case, b: Case) => number(a) - number(b));
