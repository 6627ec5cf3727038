import { between } from '../draw/between.js';
import { threeDigits } from '../draw/numbers.js';
import { markdownOf } from '../draw/table.js';
import type { PriceCell } from './measure.js';
import type { PriceNumbers } from './numbers.js';
import type { PriceScene } from './scene.js';
import { engines } from './engines.js';
import {
  COMPARED,
  cellsAt,
  costTable,
  energyTable,
  errorTable,
  hitchTable,
  sideOf,
} from './tables.js';

/** Levels whose price is judged, and how many times Ammo's step is asked of them. */
const AIMS: Record<string, (scene: PriceScene) => number> = {
  game: () => 1.5,
  standard: ({ bound = 2.5 }) => bound,
};

/** Scenes that are told of as the dearest. */
const TOLD = 5;

/** The larger of median and mean: both have to keep an aim. */
function dearness(cell: PriceCell): number {
  const ratio = sideOf(cell, 'ours')?.toAmmo;
  return ratio ? Math.max(ratio.median.median, ratio.mean.mean) : NaN;
}

/** What is asked of the first step and of all others, in medians. */
const HITCHES = { first: 5, worst: 3 } as const;

function smooth(cells: readonly PriceCell[], which: keyof typeof HITCHES): number {
  const sides = cells.map((cell) => sideOf(cell, 'ours')!);
  return sides.filter((side) => side[which] <= HITCHES[which] * side.median).length;
}

function summaryOf(numbers: PriceNumbers, level: string): string {
  const all = cellsAt(numbers, level);
  const cells = all.map(([, cell]) => cell);
  const kept = all.filter(([scene, cell]) => dearness(cell) <= AIMS[level]!(scene));
  const dearest = all
    .toSorted(([, a], [, b]) => dearness(b) - dearness(a))
    .slice(0, TOLD)
    .map(([{ name }, cell]) => `${name} (${threeDigits(dearness(cell))})`);
  return `- \`${level}\`: ${kept.length} of ${all.length} scenes keep the aim; the first step does in ${smooth(cells, 'first')}, the worst in ${smooth(cells, 'worst')}. Dearest, in Ammo's steps, the larger of median and mean: ${dearest.join('; ')}.`;
}

/** In how many scenes ours leaves less than every other engine. */
function trulyOf(numbers: PriceNumbers, judged: PriceScene['judged'], what: string): string {
  const cells = cellsAt(numbers, COMPARED).filter(([scene]) => scene.judged === judged);
  const left = (cell: PriceCell, engine: string): number =>
    sideOf(cell, engine)?.errors[judged] ?? Infinity;
  const first = cells.filter(([, cell]) =>
    engines.every(({ id }) => id === 'ours' || left(cell, 'ours') < left(cell, id)),
  );
  return `- ${what} at \`${COMPARED}\`: in ${first.length} of ${cells.length} scenes less than in Ammo, in Rapier and in Jolt.`;
}

/** More than this on each core, and others were at work. */
const BUSY = 1;

function conditions({ cells }: PriceNumbers): string {
  const turns = Math.min(...cells.map((cell) => cell.turns));
  const where = [...new Set(cells.map(({ date, machine }) => `- ${date}, ${machine}`))];
  const loads = cells.map(({ load }) => load);
  const [least, most] = [Math.min(...loads), Math.max(...loads)].map(threeDigits);
  const busy =
    Math.max(...loads) > BUSY
      ? ' **The machine had other work beside**: ratios bear that, milliseconds, first and worst steps less so. To be measured anew on a quiet one.'
      : '';
  return `${turns} turns of each engine.\n\n${where.join('\n')}\n\nLoad on each core meanwhile: ${least} to ${most}.${busy}`;
}

const byLevel = (table: (level: string) => string): string =>
  Object.keys(AIMS)
    .map((level) => `### \`${level}\`\n\n${table(level)}`)
    .join('\n\n');

/** docs/price.md with what these numbers say. */
export const withPrice = (text: string, numbers: PriceNumbers): string =>
  Object.entries({
    summary: [
      ...Object.keys(AIMS).map((level) => summaryOf(numbers, level)),
      trulyOf(numbers, 'overlap', 'Deepest overlap'),
      trulyOf(numbers, 'gap', 'Widest gap'),
    ].join('\n'),
    conditions: conditions(numbers),
    costs: byLevel((level) => markdownOf(costTable(numbers, level))),
    hitches: byLevel((level) => markdownOf(hitchTable(numbers, level))),
    overlaps: markdownOf(errorTable(numbers, 'overlap')),
    gaps: markdownOf(errorTable(numbers, 'gap')),
    energy: markdownOf(energyTable(numbers)),
  }).reduce((now, [name, content]) => between(now, name, content), text);
