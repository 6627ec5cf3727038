import { TitleComponent } from 'echarts/components';
import { use } from 'echarts/core';
import type { Judged } from '../soft/case.js';
import { others, softEngines } from '../soft/engines.js';
import { levelNames } from '../soft/levels.js';
import {
  costOf,
  errorOf,
  frontierOf,
  oursAt,
  rowsOf,
  type SoftCell,
  type SoftNumbers,
  type SoftRow,
} from '../soft/numbers.js';
import { judgedIn } from '../soft/tables.js';
import { decades, inUnit, legend, logAxis, svgOf } from './chart.js';
import { SYMBOLS } from './case-chart.js';
import { ink, inkOf, standalone } from './inks.js';
import { percent, power } from './numbers.js';

use([TitleComponent]);

/** Pixels. */
const [WIDTH, LEFT, RIGHT, GAP, TOP, HEIGHT, BETWEEN, BOTTOM] = [
  900, 60, 12, 58, 64, 150, 58, 48,
] as const;
const COLUMNS = 3;
const PANEL = (WIDTH - LEFT - RIGHT - GAP * (COLUMNS - 1)) / COLUMNS;

/** The whole, or a metre: what is further off flew apart, and is drawn on the edge. */
const MOST = 1;

interface Panel {
  judged: Judged;
  cell: SoftCell;
}

const dot = (row: SoftRow, judged: Judged): [number, number] => [
  costOf(row),
  Math.min(MOST, errorOf(row, judged)),
];

/** Its first and its last point have the names of their levels. */
const labelOf = (level: string) => ({
  label: {
    show: true,
    position: 'top' as const,
    formatter: level,
    color: ink('soft'),
    fontSize: 10,
  },
});

function ourLine({ judged, cell }: Panel) {
  const color = inkOf('ours');
  const rows = levelNames.flatMap((level) => oursAt(cell, level) ?? []);
  return {
    name: softEngines[0]!.name,
    type: 'line' as const,
    symbol: SYMBOLS.ours,
    symbolSize: 7,
    lineStyle: { color, width: 2 },
    itemStyle: { color },
    z: 5,
    data: rows.map((row, i) => ({
      value: dot(row, judged),
      ...((i === 0 || i === rows.length - 1) && labelOf(row.level!)),
    })),
  };
}

/** The best that another comes to, and, smaller and paler, all of its settings. */
const otherLines = ({ judged, cell }: Panel) =>
  others.flatMap(({ id, name }) => {
    const rows = rowsOf(cell, id);
    const common = { name, symbol: SYMBOLS[id], itemStyle: { color: inkOf(id) } };
    return [
      {
        ...common,
        type: 'line' as const,
        symbolSize: 7,
        lineStyle: { color: inkOf(id), width: 1.5 },
        data: frontierOf(rows, judged)
          .filter((row) => errorOf(row, judged) < MOST)
          .map((row) => dot(row, judged)),
      },
      {
        ...common,
        type: 'scatter' as const,
        symbolSize: 4,
        itemStyle: { color: inkOf(id), opacity: 0.5 },
        data: rows.map((row) => dot(row, judged)),
      },
    ];
  });

const left = (i: number): number => LEFT + (i % COLUMNS) * (PANEL + GAP);
const top = (i: number): number => TOP + Math.floor(i / COLUMNS) * (HEIGHT + BETWEEN);

const titleOf = ({ judged }: Panel, i: number) => ({
  text: judged.name,
  left: left(i) + PANEL / 2,
  top: top(i) - 24,
  textAlign: 'center' as const,
  textStyle: { color: ink('ink'), fontSize: 12, fontWeight: 'normal' as const },
});

function errorAxis({ judged, cell }: Panel, gridIndex: number) {
  const values = cell.rows.map((row) => dot(row, judged)[1]);
  return {
    ...logAxis('', 0, judged.unit === 'm' ? inUnit('m') : percent),
    ...decades([...values, judged.floor]),
    gridIndex,
  };
}

/** For docs/soft.md: a panel for each thing that is judged, how far off it is against what a frame of it costs. */
export function softPicture(numbers: SoftNumbers): string {
  const panels: Panel[] = judgedIn(numbers);
  const costs = numbers.cells.flatMap(({ rows }) => rows.map(costOf));
  const rows = Math.ceil(panels.length / COLUMNS);
  const svg = svgOf(
    'soft',
    { width: WIDTH, height: TOP + rows * (HEIGHT + BETWEEN) - BETWEEN + BOTTOM },
    {
      backgroundColor: ink('ground'),
      legend: legend(softEngines.map(({ name }) => name)),
      title: panels.map(titleOf),
      grid: panels.map((_, i) => ({ left: left(i), top: top(i), width: PANEL, height: HEIGHT })),
      xAxis: panels.map((_, gridIndex) => {
        const name = gridIndex + COLUMNS >= panels.length ? 'ms per frame of 1/60 s' : '';
        const axis = logAxis(name, 28, power);
        // Its last number would lie below the first of the next panel.
        const axisLabel = { ...axis.axisLabel, showMaxLabel: false };
        return { ...axis, ...decades(costs), gridIndex, axisLabel };
      }),
      yAxis: panels.map(errorAxis),
      series: panels.flatMap((panel, i) =>
        [ourLine(panel), ...otherLines(panel)].map((series) => ({
          ...series,
          xAxisIndex: i,
          yAxisIndex: i,
        })),
      ),
    },
  );
  return `${standalone(svg)}\n`;
}
