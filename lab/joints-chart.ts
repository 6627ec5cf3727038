import { init, use } from 'echarts/core';
import { ScatterChart, LineChart } from 'echarts/charts';
import { GridComponent, LegendComponent, TitleComponent } from 'echarts/components';
import { SVGRenderer } from 'echarts/renderers';
import type { Dot, Way } from './joints-error.js';

use([LineChart, ScatterChart, GridComponent, LegendComponent, TitleComponent, SVGRenderer]);

/** Told apart by people who see few colours too: by their shapes. */
const LOOKS: Record<Way, { color: string; symbol: string; label: 'top' | 'bottom' }> = {
  'with the joint solve': { color: '#0072b2', symbol: 'circle', label: 'bottom' },
  "Bullet's iterations alone": { color: '#d55e00', symbol: 'triangle', label: 'bottom' },
  'raw Ammo': { color: '#666666', symbol: 'rect', label: 'top' },
};

const metres = (value: number): string =>
  value >= 1
    ? `${value} m`
    : value >= 1e-3
      ? `${Math.round(value * 1e3)} mm`
      : `${Math.round(value * 1e6)} µm`;

const axis = (name: string, formatter: (value: number) => string) => ({
  type: 'log' as const,
  name,
  nameLocation: 'middle' as const,
  nameGap: 44,
  nameTextStyle: { color: '#222222', fontSize: 14 },
  axisLabel: { color: '#222222', fontSize: 13, formatter },
  axisLine: { show: true, lineStyle: { color: '#222222' } },
  splitLine: { show: true, lineStyle: { color: '#dddddd' } },
});

/** The powers of ten around some values. */
const decades = (values: number[]): { min: number; max: number } => ({
  min: 10 ** Math.floor(Math.log10(Math.min(...values))),
  max: 10 ** Math.ceil(Math.log10(Math.max(...values))),
});

/** Error against work, both logarithmic, as SVG on a white ground. */
export function chartOf(chain: string, dots: readonly Dot[]): string {
  const chart = init(null, null, { renderer: 'svg', ssr: true, width: 760, height: 520 });
  chart.setOption({
    animation: false,
    backgroundColor: '#ffffff',
    title: {
      text: `Chain ${chain}: greatest error of its end in the first second`,
      left: 'center',
      textStyle: { color: '#111111', fontSize: 16 },
    },
    legend: { top: 38, textStyle: { color: '#222222', fontSize: 14 } },
    grid: { left: 84, right: 40, top: 84, bottom: 64 },
    xAxis: {
      ...axis('milliseconds of work per simulated second', String),
      ...decades(dots.map(({ ms }) => ms)),
    },
    yAxis: { ...axis('error', metres), ...decades(dots.map(({ error }) => error)) },
    series: Object.entries(LOOKS).map(([way, { color, symbol, label }]) => ({
      name: way,
      type: 'line' as const,
      symbol,
      symbolSize: 11,
      lineStyle: { color, width: 2 },
      itemStyle: { color },
      data: dots
        .filter((dot) => dot.way === way)
        .map((dot) => ({
          value: [dot.ms, dot.error],
          label: {
            show: true,
            position: label,
            color,
            fontSize: 12,
            formatter: dot.label,
            textBorderColor: '#ffffff',
            textBorderWidth: 3,
          },
        })),
    })),
  });
  const svg = chart.renderToSVGString();
  chart.dispose();
  return `${svg}\n`;
}
