import { BarChart } from 'echarts/charts';
import { use } from 'echarts/core';
import { forms } from '../particles/forms.js';
import { libraryOf } from '../particles/libraries.js';
import type { PageSide, ParticleNumbers } from '../particles/numbers.js';
import { nodeScenes } from '../particles/scenes.js';
import { legend, svgOf } from './chart.js';
import { ink, inkOf, standalone } from './inks.js';
import { threeDigits } from './numbers.js';

use([BarChart]);

/** Pixels. */
const [WIDTH, NAMES, LINE, TOP, GAP, BOTTOM] = [900, 330, 20, 44, 78, 52];

/** One line: milliseconds of its parts, from the left, and of all. */
interface Line {
  name: string;
  library: string;
  parts: readonly number[];
  all: number;
}

/** Babylon.js has the colour of an engine that is not here. */
const COLORS: Record<string, string> = { ours: 'ours', 'x-ite': 'x-ite', babylon: 'jolt' };

const nodeLines = ({ node }: ParticleNumbers): Line[] =>
  node.rows.flatMap(({ scene, sides }) => {
    const { name } = nodeScenes.find(({ id }) => id === scene)!;
    return Object.entries(sides)
      .filter(([library]) => library in COLORS)
      .map(([library, { median }]) => ({
        name: library === 'ours' ? name : `${name}, ${libraryOf(library).name}`,
        library,
        parts: [median],
        all: median,
      }));
  });

const pageLines = ({ chromium }: ParticleNumbers): Line[] =>
  chromium.rows.flatMap(({ form, sides }) => {
    const { name } = forms.find(({ id }) => id === form)!;
    return Object.entries(sides)
      .filter((entry): entry is [string, PageSide] => typeof entry[1] !== 'string')
      .map(([library, { script, step, drawing }]) => ({
        name: `${name}, ${libraryOf(library).name}`,
        library,
        parts: [step.median, drawing.median],
        all: script.median,
      }));
  });

/** What is done in a step is full, what is drawn paler. */
const OPACITIES = [1, 0.5];

const bars = (lines: readonly Line[], panel: number) =>
  OPACITIES.map((opacity, part) => ({
    type: 'bar' as const,
    stack: String(panel),
    xAxisIndex: panel,
    yAxisIndex: panel,
    barWidth: 11,
    data: lines.map(({ library, parts }) => ({
      value: parts[part] ?? 0,
      itemStyle: { color: inkOf(COLORS[library]!), opacity },
    })),
    label: {
      show: part === OPACITIES.length - 1,
      position: 'right' as const,
      color: ink('ink'),
      opacity: 1,
      fontSize: 12,
      formatter: ({ dataIndex }: { dataIndex: number }) => threeDigits(lines[dataIndex]!.all),
    },
  }));

const names = (lines: readonly Line[], gridIndex: number) => ({
  gridIndex,
  type: 'category' as const,
  data: lines.map(({ name }) => name),
  inverse: true,
  axisLabel: { color: ink('ink'), fontSize: 12, interval: 0 },
  axisLine: { lineStyle: { color: ink('soft') } },
  axisTick: { show: false },
});

const milliseconds = (name: string, gridIndex: number) => ({
  gridIndex,
  type: 'value' as const,
  name,
  nameLocation: 'middle' as const,
  nameGap: 28,
  nameTextStyle: { color: ink('ink'), fontSize: 13 },
  axisLabel: { color: ink('soft'), fontSize: 12 },
  splitLine: { show: true, lineStyle: { color: ink('line') } },
});

/** For the legend alone: no bars. */
const keys = Object.entries(COLORS).map(([library, color]) => ({
  name: libraryOf(library).name,
  type: 'bar' as const,
  itemStyle: { color: inkOf(color) },
  data: [],
}));

/** For docs/particles-price.md: a step in Node, and below it the steps and the drawing of a frame in a page. */
export function particlesPicture(numbers: ParticleNumbers): string {
  const panels = [nodeLines(numbers), pageLines(numbers)];
  const heights = panels.map((lines) => LINE * lines.length);
  const tops = [TOP, TOP + heights[0]! + GAP];
  const size = { width: WIDTH, height: tops[1]! + heights[1]! + BOTTOM };
  const svg = svgOf('particles', size, {
    backgroundColor: ink('ground'),
    legend: legend(keys.map(({ name }) => ({ name, icon: 'rect' }))),
    grid: heights.map((height, i) => ({ left: NAMES, right: 60, top: tops[i]!, height })),
    xAxis: [
      milliseconds('ms of a step in Node', 0),
      milliseconds('ms of script in a frame of Chromium: steps, and paler what draws', 1),
    ],
    yAxis: panels.map(names),
    series: [...keys, ...panels.flatMap(bars)],
  });
  return `${standalone(svg)}\n`;
}
