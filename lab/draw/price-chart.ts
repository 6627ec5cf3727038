import { TitleComponent } from 'echarts/components';
import { use } from 'echarts/core';
import { engines, levelNames } from '../price/engines.js';
import type { Side } from '../price/measure.js';
import { cellOf, type PriceNumbers } from '../price/numbers.js';
import type { PriceScene } from '../price/scene.js';
import { priceScenes } from '../price/scenes/index.js';
import { COMPARED, sideOf } from '../price/tables.js';
import { inUnit, legend, logAxis, svgOf } from './chart.js';
import { SYMBOLS } from './case-chart.js';
import { ink, inkOf, standalone } from './inks.js';
import { power } from './numbers.js';

use([TitleComponent]);

/** Pixels. */
const [WIDTH, LEFT, RIGHT, GAP, TOP, HEIGHT, BETWEEN, BOTTOM] = [
  900, 76, 12, 16, 60, 130, 36, 48,
] as const;
const COLUMNS = 4;
const PANEL = (WIDTH - LEFT - RIGHT - GAP * (COLUMNS - 1)) / COLUMNS;

interface Range {
  min: number;
  max: number;
}

/** Milliseconds of work per simulated second, the same in all panels. */
const TIME: Range = { min: 1, max: 1e5 };

/** A second of work for a second of the scene. */
const REAL_TIME = 1000;

/** Metres. What is below is drawn on the edge. */
const ERRORS: Record<PriceScene['judged'], Range & { name: string }> = {
  overlap: { name: 'deepest overlap', min: 1e-5, max: 1 },
  gap: { name: 'widest gap', min: 1e-7, max: 10 },
};

const within = (value: number, { min, max }: Range): number => Math.min(max, Math.max(min, value));

const pointOf = ({ judged }: PriceScene, { mean, errors }: Side, step: number) => [
  within(mean / step, TIME),
  within(errors[judged] ?? 0, ERRORS[judged]),
];

/** Its first and its last point have the names of their levels. */
const levelLabel = (level: string, at: 'first' | 'last') => ({
  show: true,
  position: at === 'first' ? ('top' as const) : ('right' as const),
  formatter: level,
  color: ink('soft'),
  fontSize: 10,
});

function ourLine(numbers: PriceNumbers, scene: PriceScene) {
  const points = levelNames.flatMap((level) => {
    const cell = cellOf(numbers, scene.id, level);
    const side = sideOf(cell, 'ours');
    return side ? [{ level, value: pointOf(scene, side, cell!.step) }] : [];
  });
  const color = inkOf('ours');
  return {
    name: engines[0]!.name,
    type: 'line' as const,
    symbol: 'circle',
    symbolSize: 7,
    lineStyle: { color, width: 2 },
    itemStyle: { color },
    data: points.map(({ level, value }, i) => ({
      value,
      ...(i === 0 && { label: levelLabel(level, 'first') }),
      ...(i > 0 && i === points.length - 1 && { label: levelLabel(level, 'last') }),
    })),
  };
}

/** Another engine, with the step of one level. */
function otherPoint(numbers: PriceNumbers, scene: PriceScene, id: string, name: string) {
  const cell = cellOf(numbers, scene.id, COMPARED);
  const side = sideOf(cell, id);
  return {
    name,
    type: 'scatter' as const,
    symbol: SYMBOLS[id],
    symbolSize: 9,
    z: 4,
    itemStyle: { color: inkOf(id) },
    data: side ? [pointOf(scene, side, cell!.step)] : [],
  };
}

const realTime = ({ judged }: PriceScene) => ({
  type: 'line' as const,
  symbol: 'none',
  lineStyle: { color: ink('soft'), width: 1, type: 'dashed' as const },
  data: [
    [REAL_TIME, ERRORS[judged].min],
    [REAL_TIME, ERRORS[judged].max],
  ],
});

/** A scene, where its panel is, and whether there is none below it that is judged alike. */
interface Panel {
  scene: PriceScene;
  column: number;
  row: number;
  isLowest: boolean;
}

/** What is judged alike stands together. */
function panelsOf(scenes: readonly PriceScene[]): Panel[] {
  let first = 0;
  return Object.keys(ERRORS).flatMap((judged) => {
    const alike = scenes.filter((scene) => scene.judged === judged);
    const from = first;
    first += Math.ceil(alike.length / COLUMNS);
    return alike.map((scene, i) => ({
      scene,
      column: i % COLUMNS,
      row: from + Math.floor(i / COLUMNS),
      isLowest: i + COLUMNS >= alike.length,
    }));
  });
}

const left = ({ column }: Panel): number => LEFT + column * (PANEL + GAP);

/** Below the last panels that are judged alike there are numbers. */
const top = ({ row, scene }: Panel): number =>
  TOP + row * (HEIGHT + BETWEEN) + (scene.judged === 'gap' ? BOTTOM - BETWEEN / 2 : 0);

const titleOf = (panel: Panel) => ({
  text: panel.scene.name,
  left: left(panel) + PANEL / 2,
  top: top(panel) - 24,
  textAlign: 'center' as const,
  textStyle: { color: ink('ink'), fontSize: 12, fontWeight: 'normal' as const },
});

/** Its last number would lie on the first of the next panel. */
function timeAxis({ isLowest }: Panel, gridIndex: number) {
  const axis = logAxis(isLowest ? 'ms per simulated second' : '', 28, power);
  const axisLabel = { ...axis.axisLabel, show: isLowest, showMaxLabel: false };
  return { ...axis, ...TIME, gridIndex, axisLabel };
}

function errorAxis({ column, scene: { judged } }: Panel, gridIndex: number) {
  const { name, ...range } = ERRORS[judged];
  return {
    ...logAxis(column === 0 ? name : '', 56, inUnit('m')),
    ...range,
    gridIndex,
    ...(column > 0 && { axisLabel: { show: false } }),
  };
}

/** For docs/price.md: a panel for each scene, what is left against the time it takes. */
export function pricePicture(numbers: PriceNumbers): string {
  const panels = panelsOf(priceScenes.filter(({ id }) => cellOf(numbers, id, COMPARED)));
  const lowest = Math.max(...panels.map(top));
  const svg = svgOf(
    'price',
    { width: WIDTH, height: lowest + HEIGHT + BOTTOM },
    {
      backgroundColor: ink('ground'),
      legend: legend(engines.map(({ name }) => name)),
      title: panels.map(titleOf),
      grid: panels.map((panel) => ({
        left: left(panel),
        top: top(panel),
        width: PANEL,
        height: HEIGHT,
      })),
      xAxis: panels.map(timeAxis),
      yAxis: panels.map(errorAxis),
      series: panels.flatMap(({ scene }, i) =>
        [
          realTime(scene),
          ourLine(numbers, scene),
          ...engines.slice(1).map(({ id, name }) => otherPoint(numbers, scene, id, name)),
        ].map((series) => ({ ...series, xAxisIndex: i, yAxisIndex: i })),
      ),
    },
  );
  return `${standalone(svg)}\n`;
}
