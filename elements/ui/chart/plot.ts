import { LineChart } from 'echarts/charts';
import { GridComponent } from 'echarts/components';
import { init, use } from 'echarts/core';
import { SVGRenderer } from 'echarts/renderers';
import { ERRORS, type ErrorName } from './errors.js';

use([LineChart, GridComponent, SVGRenderer]);

/** One level. */
export interface Dot {
  level: string;
  cost: number;
  error: number;
  /** In force now. */
  present: boolean;
}

export interface Colors {
  text: string;
  quiet: string;
  line: string;
  accent: string;
  panel: string;
  warning: string;
}

export interface Drawing {
  dots: readonly Dot[];
  kind: ErrorName;
  /** Milliseconds per simulated second that the frame budget allows. */
  budget: number;
  colors: Colors;
  width: number;
  height: number;
}

/** Room for a level's name beside its dot: so much farther to the right. */
const NAME = 4;

interface Range {
  min: number;
  max: number;
}

/** The powers of ten around some values. */
function decades(values: readonly number[]): Range {
  const min = 10 ** Math.floor(Math.log10(Math.min(...values)));
  const max = 10 ** Math.ceil(Math.log10(Math.max(...values)));
  return { min, max: max > min ? max : min * 10 };
}

/** Errors that are zero have no place on a logarithmic axis: they stand a decade below the least. */
function heights(dots: readonly Dot[]): { heights: number[]; range: Range } {
  const some = dots.map(({ error }) => error).filter((error) => error > 0);
  const { min, max } = decades(some.length > 0 ? some : [1e-6]);
  const floor = dots.some(({ error }) => error === 0) ? min / 10 : min;
  return {
    heights: dots.map(({ error }) => (error > 0 ? error : floor)),
    range: { min: floor, max },
  };
}

/** Error against cost, both logarithmic, as the text of an SVG. */
export function plot({ dots, kind, budget, colors, width, height }: Drawing): string {
  const chart = init(null, null, { renderer: 'svg', ssr: true, width, height });
  const { heights: errors, range } = heights(dots);
  const most = Math.max(...dots.map(({ cost }) => cost));
  const costs = decades([...dots.map(({ cost }) => cost), budget || most, NAME * most]);
  const axis = (name: string, { min, max }: Range, formatter: (value: number) => string) => ({
    type: 'log' as const,
    name,
    min,
    max,
    nameLocation: 'middle' as const,
    nameTextStyle: { color: colors.text },
    axisLabel: { color: colors.quiet, formatter, hideOverlap: true },
    axisLine: { show: true, lineStyle: { color: colors.quiet } },
    splitLine: { show: true, lineStyle: { color: colors.line } },
  });
  const floorLabel = (value: number): string =>
    value < range.min * 1.01 && dots.some(({ error }) => error === 0)
      ? '0'
      : ERRORS[kind].text(value);
  chart.setOption({
    animation: false,
    textStyle: { fontFamily: 'system-ui, sans-serif' },
    grid: { left: 76, right: 24, top: 28, bottom: 48 },
    xAxis: { ...axis('ms of work per simulated second', costs, String), nameGap: 30 },
    yAxis: { ...axis(ERRORS[kind].axis, range, floorLabel), nameGap: 58 },
    series: [
      ...(budget > 0 ? [budgetLine(budget, range, colors)] : []),
      levelsLine(dots, errors, colors),
    ],
  });
  const svg = chart.renderToSVGString();
  chart.dispose();
  return svg;
}

const budgetLine = (budget: number, { min, max }: Range, colors: Colors) => ({
  type: 'line' as const,
  symbol: 'none',
  lineStyle: { color: colors.warning, type: 'dashed' as const, width: 2 },
  data: [
    [budget, min],
    {
      value: [budget, max],
      symbol: 'circle',
      symbolSize: 1,
      label: {
        show: true,
        position: 'top' as const,
        color: colors.warning,
        formatter: 'frame budget',
      },
    },
  ],
});

/** The level in force is the filled one; those compared with nothing, or without error, are drawn at the bottom. */
const levelsLine = (dots: readonly Dot[], errors: readonly number[], colors: Colors) => ({
  type: 'line' as const,
  lineStyle: { color: colors.accent, width: 2 },
  data: dots.map(({ level, cost, present }, i) => ({
    value: [cost, errors[i]!],
    symbol: 'circle',
    symbolSize: present ? 16 : 10,
    itemStyle: {
      color: present ? colors.accent : colors.panel,
      borderColor: colors.accent,
      borderWidth: 2,
    },
    label: {
      show: true,
      position: 'right' as const,
      distance: 8,
      // Above the axis, where there is no error.
      offset: [0, dots[i]!.error > 0 ? 0 : -9],
      color: colors.text,
      fontWeight: present ? ('bold' as const) : ('normal' as const),
      formatter: level,
      textBorderColor: colors.panel,
      textBorderWidth: 3,
    },
  })),
});
