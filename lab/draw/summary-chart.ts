import { floorOf, type Case } from '../case.js';
import type { Row } from '../run/row.js';
import { decades, legend, logAxis, SIZES, svgOf, type Size } from './chart.js';
import { ink, inkOf } from './inks.js';
import { duel, errorOf, ladderOf, type Duel } from './judge.js';
import { power } from './numbers.js';

// One line per case: our `standard` and the best of raw Ammo in the same time, as shares of the quantity's size.

const LINE_HEIGHT = 21;

interface Line {
  which: Case;
  duel: Duel;
  /** Errors at our other levels. */
  others: number[];
}

/** Where we gain most first. */
function linesOf(cases: readonly Case[], rows: readonly Row[]): Line[] {
  return cases
    .flatMap((which) => {
      const found = duel(which, 'ammo', rows);
      if (!found) return [];
      const others = ladderOf(which, rows)
        .filter(({ level }) => level !== 'standard')
        .map(errorOf)
        .filter(Number.isFinite);
      return [{ which, duel: found, others }];
    })
    .sort((a, b) => (a.duel.factor ?? 0) - (b.duel.factor ?? 0));
}

/** What is under the floor is drawn at it: it counts as none. */
const share = (which: Case, error: number): number => Math.max(error, floorOf(which)) / which.size;

const STANDARD = 'x3d-physics at standard';
const OTHERS = 'its other levels';
const AMMO = 'the best of raw Ammo in the same time';

/** Pixels for the names of the cases. */
const NAMES = { wide: 250, narrow: 132 };

export function summaryChart(cases: readonly Case[], rows: readonly Row[], size: Size): string {
  const lines = linesOf(cases, rows);
  const names = lines.map(({ which: { name } }) => name);
  const theirs = lines.map(({ which, duel: { theirs: error } }) =>
    error !== null && Number.isFinite(error) ? share(which, error) : null,
  );
  const ours = lines.map(({ which, duel: { ours: error } }) => share(which, error));
  const dots = (name: string, data: (number | null)[], color: string, symbol: string) => ({
    name,
    type: 'scatter' as const,
    symbol,
    symbolSize: 10,
    z: 4,
    itemStyle: { color },
    data: data.flatMap((value, i) => (value === null ? [] : [[value, i]])),
  });
  const height = 96 + (size === 'narrow' ? 40 : 0) + LINE_HEIGHT * lines.length;
  return svgOf(
    `summary-${size}`,
    { width: SIZES[size].width, height },
    {
      legend: legend([STANDARD, OTHERS, AMMO]),
      grid: { left: NAMES[size], right: 24, top: size === 'wide' ? 32 : 72, bottom: 48 },
      xAxis: {
        ...logAxis('error as a share of the quantity itself', 30, power),
        ...decades([...ours, ...theirs.flatMap((value) => value ?? [])]),
      },
      yAxis: {
        type: 'category' as const,
        data: names,
        axisLabel: {
          color: ink('ink'),
          fontSize: 12,
          interval: 0,
          width: NAMES[size] - 12,
          overflow: 'truncate' as const,
        },
        axisLine: { lineStyle: { color: ink('soft') } },
        axisTick: { show: false },
      },
      series: [
        ...lines.flatMap((_, i) =>
          theirs[i] === null
            ? []
            : [
                {
                  type: 'line' as const,
                  symbol: 'none',
                  lineStyle: { color: inkOf(ours[i]! <= theirs[i]! ? 'ours' : 'ammo'), width: 2 },
                  data: [
                    [ours[i]!, i],
                    [theirs[i]!, i],
                  ],
                },
              ],
        ),
        {
          name: OTHERS,
          type: 'scatter' as const,
          symbol: 'circle',
          symbolSize: 5,
          itemStyle: { color: inkOf('ours'), opacity: 0.55 },
          data: lines.flatMap(({ which, others }, i) =>
            others.map((error) => [share(which, error), i]),
          ),
        },
        dots(AMMO, theirs, inkOf('ammo'), 'rect'),
        dots(STANDARD, ours, inkOf('ours'), 'circle'),
      ],
    },
  );
}
