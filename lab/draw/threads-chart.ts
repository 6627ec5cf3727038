import { TitleComponent } from 'echarts/components';
import { use } from 'echarts/core';
import type { ThreadCell, ThreadNumbers } from '../page/threads/numbers.js';
import { decades, legend, logAxis, svgOf } from './chart.js';
import { ink, inkOf, standalone } from './inks.js';
import { power } from './numbers.js';
import { BROWSER_NAMES } from './pages-chart.js';

use([TitleComponent]);

/** Milliseconds of one line. */
type Value = (cell: ThreadCell) => number;

/** Frames: as they are in the middle, and all but five of a hundred. */
const LINES: { name: string; color: string; median: Value; most?: Value }[] = [
  {
    name: 'physics, thread="main"',
    color: 'iterated',
    median: ({ main }) => main.own.median,
    most: ({ main }) => main.own.most,
  },
  {
    name: 'physics, thread="worker"',
    color: 'ours',
    median: ({ worker }) => worker.own.median,
    most: ({ worker }) => worker.own.most,
  },
  { name: 'x3dom’s drawing', color: 'ammo', median: ({ main }) => main.drawing.median },
];

/** Pixels. */
const [WIDTH, LEFT, GAP, TOP, HEIGHT] = [860, 64, 48, 64, 300];

const lineOf = (cells: readonly ThreadCell[], name: string, color: string, of: Value) => ({
  name,
  type: 'line' as const,
  symbol: 'circle',
  symbolSize: 7,
  itemStyle: { color: inkOf(color) },
  lineStyle: { color: inkOf(color), width: 2 },
  data: cells.map((cell) => [cell.count, of(cell)]),
});

/** Of the same colour, and in no legend. */
const mostOf = (cells: readonly ThreadCell[], color: string, of: Value) => ({
  ...lineOf(cells, '', color, of),
  symbol: 'none',
  lineStyle: { color: inkOf(color), width: 1.5, type: 'dashed' as const },
});

/** For docs/pages.md and the guide: what physics costs the page's own thread, on it and with a worker, and drawing. */
export function threadsPicture({ browsers }: ThreadNumbers): string {
  const shown = Object.entries(browsers);
  const width = (WIDTH - LEFT - 12 - GAP * (shown.length - 1)) / shown.length;
  const left = (i: number): number => LEFT + i * (width + GAP);
  const cells = shown.flatMap(([, browser]) => browser.cells);
  const counts = cells.map(({ count }) => count);
  const values = LINES.flatMap(({ median, most = median }) =>
    cells.flatMap((cell) => [median(cell), most(cell)]),
  );
  const svg = svgOf(
    'pages-threads',
    { width: WIDTH, height: TOP + HEIGHT + 56 },
    {
      backgroundColor: ink('ground'),
      legend: legend(LINES.map(({ name }) => name)),
      title: shown.map(([name], i) => ({
        text: BROWSER_NAMES[name],
        left: left(i) + width / 2,
        top: 30,
        textAlign: 'center' as const,
        textStyle: { color: ink('ink'), fontSize: 14, fontWeight: 'normal' as const },
      })),
      grid: shown.map((_, i) => ({ left: left(i), top: TOP, width, height: HEIGHT })),
      xAxis: shown.map((_, gridIndex) => ({
        ...logAxis('boxes', 30, power),
        gridIndex,
        min: Math.min(...counts),
        max: Math.max(...counts),
      })),
      yAxis: shown.map((_, gridIndex) => ({
        ...logAxis(gridIndex === 0 ? 'script per frame, ms' : '', 44, power),
        gridIndex,
        ...decades(values),
      })),
      series: shown.flatMap(([, browser], i) =>
        LINES.flatMap(({ name, color, median, most }) => [
          lineOf(browser.cells, name, color, median),
          ...(most ? [mostOf(browser.cells, color, most)] : []),
        ]).map((line) => ({ ...line, xAxisIndex: i, yAxisIndex: i })),
      ),
    },
  );
  return `${standalone(svg)}\n`;
}
