import { percent, threeDigits } from '../../draw/numbers.js';
import { columnsOf } from '../../draw/table.js';
import type { ThreadCell } from './numbers.js';

/** How far the run is, for people who wait for it. */
export function cellText(browser: string, { count, main, worker, alone }: ThreadCell): string {
  const rows = Object.entries({ main, worker }).map(
    ([name, { own, drawing, kept, steady, late }]) => [
      name,
      ...[own.median, own.most, drawing.median, drawing.most].map(threeDigits),
      percent(kept),
      `${steady.frame.median} (${steady.frame.most}) ${threeDigits(steady.behind.median)} (${threeDigits(steady.behind.most)})`,
      `${late.frame.median} (${late.frame.most})`,
      `${threeDigits(late.behind.median)} (${threeDigits(late.behind.most)}), ${late.edits}`,
    ],
  );
  const head = ['', 'ours, ms', '95 %', 'drawing', '95 %', 'kept', 'steady', 'frame', 'behind, ms'];
  return `${browser}, ${count} boxes, drawing alone keeps ${percent(alone)}\n${columnsOf([head, ...rows], 1)}`;
}
