import { LineChart, ScatterChart } from 'echarts/charts';
import { GridComponent, LegendComponent } from 'echarts/components';
import { init, use, type EChartsCoreOption } from 'echarts/core';
import { SVGRenderer } from 'echarts/renderers';
import { power, quantity } from './numbers.js';
import { ink } from './inks.js';

use([LineChart, ScatterChart, GridComponent, LegendComponent, SVGRenderer]);

/** For a desk and for a telephone, pixels. */
export const SIZES = {
  wide: { width: 860, height: 560 },
  narrow: { width: 358, height: 520 },
} as const;

export type Size = keyof typeof SIZES;

/** Widths of text are guessed by this family's. */
const FONT = "Arial, Helvetica, 'Liberation Sans', sans-serif";

/** `name`: no other drawing of the page has it. */
export function svgOf(
  name: string,
  { width, height }: { width: number; height: number },
  option: EChartsCoreOption,
): string {
  const chart = init(null, null, { renderer: 'svg', ssr: true, width, height });
  chart.setOption({ animation: false, textStyle: { fontFamily: FONT }, ...option });
  const svg = chart.renderToSVGString();
  chart.dispose();
  return named(svg, name);
}

/** echarts counts its drawings into their ids and classes; the classes are for what lies under a pointer alone. */
const named = (svg: string, name: string): string =>
  svg
    .replace(/<style\b.*?<\/style>\s*/s, '')
    .replaceAll(/ class="zr[^"]*"/g, '')
    .replaceAll(/\bzr\d+-/g, `${name}-`);

export const decades = (values: readonly number[]): { min: number; max: number } => ({
  min: 10 ** Math.floor(Math.log10(Math.min(...values))),
  max: 10 ** Math.ceil(Math.log10(Math.max(...values))),
});

/** What the marks stand for, above the chart. */
export const legend = (data: readonly (string | { name: string; icon: string })[]) => ({
  top: 0,
  left: 'center',
  itemGap: 18,
  itemWidth: 22,
  itemHeight: 10,
  textStyle: { color: ink('ink'), fontSize: 12 },
  data,
});

/** A logarithmic axis with a line at each power of ten. */
export const logAxis = (name: string, gap: number, formatter: (value: number) => string) => ({
  type: 'log' as const,
  name,
  nameLocation: 'middle' as const,
  nameGap: gap,
  nameTextStyle: { color: ink('ink'), fontSize: 13 },
  axisLabel: { color: ink('soft'), fontSize: 12, formatter, hideOverlap: true },
  axisLine: { show: true, lineStyle: { color: ink('soft') } },
  axisTick: { show: false },
  splitLine: { show: true, lineStyle: { color: ink('line') } },
});

export const inUnit =
  (unit: string) =>
  (value: number): string =>
    unit === 'm' ? quantity(value, 'm') : power(value);
