import { percent, threeDigits } from '../../draw/numbers.js';
import { BROWSER_NAMES } from '../../draw/pages-chart.js';
import type { Table } from '../../draw/table.js';
import type { ThreadCell, ThreadNumbers, ThreadSide } from './numbers.js';

const upTo = ({ median, most }: { median: number; most: number }): string =>
  `${threeDigits(median)}, ${threeDigits(most)}`;

const sideOf = ({ own, drawing, kept, steady, late }: ThreadSide): string[] => [
  upTo(own),
  upTo(drawing),
  percent(kept),
  `${upTo(steady.frame)}: ${upTo(steady.behind)}`,
  `${upTo(late.frame)}: ${upTo(late.behind)}`,
];

function rowsOf(browser: string, { count, main, worker, ratio, alone }: ThreadCell): string[][] {
  const { median, low, high } = ratio;
  const name = `${BROWSER_NAMES[browser]}, ${count} boxes`;
  return [
    [`${name}, \`main\``, ...sideOf(main), '–'],
    [
      `${name}, \`worker\``,
      ...sideOf(worker),
      `${threeDigits(median)} (${threeDigits(low)} – ${threeDigits(high)})`,
    ],
    [`${name}, drawing alone`, '–', '–', percent(alone), '–', '–', '–'],
  ];
}

/** What either thread costs the page's own, and what it gives. */
export const threadTable = ({ browsers }: ThreadNumbers): Table => ({
  head: [
    'median, and what 95 of 100 do not exceed',
    'our script, ms',
    'drawing, ms',
    'frames kept',
    'an edit is seen in frame: ms behind, where the worker keeps up',
    'the same in frames of this machine',
    'our script to that of `main`',
  ],
  rows: Object.entries(browsers).flatMap(([name, { cells }]) =>
    cells.flatMap((cell) => rowsOf(name, cell)),
  ),
});

const middle = ({ median }: { median: number }): string => threeDigits(median);

/** For the guide: Chromium's alone, in short. */
export const guideTable = ({ browsers }: ThreadNumbers): Table => ({
  head: ['boxes', '`main`, ms', '`worker`, ms', '`worker` to `main`', 'drawing, ms'],
  rows: browsers.chromium!.cells.map(({ count, main, worker, ratio }) => [
    String(count),
    ...[main.own, worker.own].map(middle),
    percent(ratio.median),
    middle(main.drawing),
  ]),
});

/** When, on what, and how busy that was. */
export const threadConditions = ({ warmUp, frames, browsers }: ThreadNumbers): string =>
  [
    `${frames} frames of each, after ${warmUp}:`,
    '',
    ...Object.entries(browsers).map(([name, { version, machine, cells }]) => {
      const when = cells.map(
        ({ count, date, load }) => `${count} boxes ${date} at a load of ${threeDigits(load)}`,
      );
      return `- ${BROWSER_NAMES[name]} ${version}: ${machine}; ${when.join(', ')}`;
    }),
  ].join('\n');
