import { TitleComponent } from 'echarts/components';
import { use } from 'echarts/core';
import { libraryOf } from '../page/libraries/index.js';
import type { BrowserPages, PageCell, PageNumbers } from '../page/numbers.js';
import { legend, logAxis, svgOf } from './chart.js';
import { ink, inkOf, standalone } from './inks.js';
import { power } from './numbers.js';

use([TitleComponent]);

/** Names as they are written. */
export const BROWSER_NAMES: Record<string, string> = {
  chromium: 'Chromium',
  firefox: 'Firefox',
  webkit: 'WebKitGTK',
};

/** Lines that lie on ours are left to the tables. */
const SIDES = ['ours', 'x-ite', 'a-frame', 'ammo'];

type Value = (cell: PageCell, side: string) => number | undefined;

const scriptPart =
  (part: 'physics' | 'drawing'): Value =>
  ({ script }, side) => {
    const cost = script[side];
    if (!cost || typeof cost === 'string') return undefined;
    if (side === 'ammo') return part === 'physics' ? cost.script.median : undefined;
    return cost[part].median;
  };

const perSecond: Value = ({ frames }, side) => {
  const rate = frames[side];
  return rate && typeof rate !== 'string' ? rate.perSecond : undefined;
};

const ROWS: readonly { name: string; of: Value; min: number; max: number }[] = [
  { name: 'physics, ms', of: scriptPart('physics'), min: 0.01, max: 1000 },
  { name: 'drawing, ms', of: scriptPart('drawing'), min: 0.01, max: 1000 },
  { name: 'frames per second', of: perSecond, min: 0.1, max: 100 },
];

/** Pixels. */
const [WIDTH, LEFT, GAP, TOP, HEIGHT, BETWEEN] = [860, 64, 48, 64, 170, 26];

function lineOf(pages: BrowserPages, scene: string, of: Value, side: string) {
  const data = pages.cells
    .filter((cell) => cell.scene === scene)
    .flatMap((cell) => {
      const value = of(cell, side);
      return value === undefined ? [] : [[cell.count, Math.max(0.01, value)]];
    });
  // Rapier is in none of these pictures.
  const color = inkOf(side === 'a-frame' ? 'rapier' : side);
  return {
    name: libraryOf(side).name,
    type: 'line' as const,
    symbol: 'circle',
    symbolSize: 6,
    lineStyle: { color, width: 2 },
    itemStyle: { color },
    data,
  };
}

/** For docs/pages.md: a column for each browser; physics, drawing and frames against how many there are. */
export function pagesPicture({ browsers }: PageNumbers, scene: string, things: string): string {
  const names = Object.keys(browsers).filter((name) =>
    browsers[name]!.cells.some((cell) => cell.scene === scene),
  );
  const width = (WIDTH - LEFT - 12 - GAP * (names.length - 1)) / names.length;
  const panels = ROWS.flatMap((row, r) => names.map((name, c) => ({ row, r, name, c })));
  const top = (r: number): number => TOP + r * (HEIGHT + BETWEEN);
  const last = ROWS.length - 1;
  const counts = names.flatMap((name) =>
    browsers[name]!.cells.flatMap((cell) => (cell.scene === scene ? cell.count : [])),
  );
  const svg = svgOf(
    `pages-${scene}`,
    { width: WIDTH, height: top(last) + HEIGHT + 48 },
    {
      backgroundColor: ink('ground'),
      legend: legend(SIDES.map((side) => libraryOf(side).name)),
      title: names.map((name, c) => ({
        text: BROWSER_NAMES[name],
        left: LEFT + c * (width + GAP) + width / 2,
        top: 30,
        textAlign: 'center' as const,
        textStyle: { color: ink('ink'), fontSize: 14, fontWeight: 'normal' as const },
      })),
      grid: panels.map(({ r, c }) => ({
        left: LEFT + c * (width + GAP),
        top: top(r),
        width,
        height: HEIGHT,
      })),
      xAxis: panels.map(({ r }, i) => ({
        ...logAxis(r === last ? things : '', 28, power),
        gridIndex: i,
        min: Math.min(...counts),
        max: Math.max(...counts),
        ...(r < last && { axisLabel: { show: false } }),
      })),
      yAxis: panels.map(({ row, c }, i) => ({
        ...logAxis(c === 0 ? row.name : '', 44, power),
        gridIndex: i,
        min: row.min,
        max: row.max,
      })),
      series: panels.flatMap(({ row, name }, i) =>
        SIDES.map((side) => ({
          ...lineOf(browsers[name]!, scene, row.of, side),
          xAxisIndex: i,
          yAxisIndex: i,
        })),
      ),
    },
  );
  return `${standalone(svg)}\n`;
}
