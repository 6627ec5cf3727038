import { BarChart } from 'echarts/charts';
import { use } from 'echarts/core';
import type { EffectNumbers } from '../effects/numbers.js';
import { logAxis, svgOf } from './chart.js';
import { ink, inkOf, standalone } from './inks.js';
import { power, threeDigits } from './numbers.js';

use([BarChart]);

/** Milliseconds; what lies below can't be told from nothing. */
const LEAST = 0.001;

/** Pixels. */
const [WIDTH, NAMES, GAP, KILOBYTES, LABEL, LINE] = [900, 350, 24, 110, 84, 22];

const axis = (names: readonly string[], labels: boolean) => ({
  type: 'category' as const,
  data: names,
  inverse: true,
  axisLabel: { show: labels, color: ink('ink'), fontSize: 12, interval: 0 },
  axisLine: { lineStyle: { color: ink('soft') } },
  axisTick: { show: false },
});

/** For docs/effects.md: of each effect what it adds to a step, with its interval, and what a page fetches for it. */
export function effectsPicture({ bodies, costs }: EffectNumbers): string {
  const sorted = costs.toSorted((a, b) => b.ms.median - a.ms.median);
  const names = sorted.map(({ effect, by }) => `${effect}: ${by}`);
  const at = (ms: number): number => Math.max(LEAST, ms);
  const most = Math.max(...sorted.map(({ ms }) => ms.high));
  const bars = { left: WIDTH - KILOBYTES - LABEL, width: KILOBYTES };
  const area = { top: 8, height: LINE * sorted.length };
  const color = inkOf('ours');
  const svg = svgOf(
    'effects',
    { width: WIDTH, height: area.height + 56 },
    {
      backgroundColor: ink('ground'),
      grid: [
        { ...area, left: NAMES, right: WIDTH - bars.left + GAP },
        { ...area, ...bars },
      ],
      xAxis: [
        {
          ...logAxis(`ms that it adds to a step of ${bodies} bodies`, 28, power),
          min: LEAST,
          max: 10 ** Math.ceil(Math.log10(most)),
        },
        {
          gridIndex: 1,
          type: 'value' as const,
          interval: 10,
          name: 'kB of the file with its code',
          nameLocation: 'middle' as const,
          nameGap: 28,
          nameTextStyle: { color: ink('ink'), fontSize: 13 },
          axisLabel: { color: ink('soft'), fontSize: 12 },
          splitLine: { show: true, lineStyle: { color: ink('line') } },
        },
      ],
      yAxis: [axis(names, true), { ...axis(names, false), gridIndex: 1 }],
      series: [
        ...sorted.map(({ ms }, i) => ({
          type: 'line' as const,
          symbol: 'none',
          lineStyle: { color, width: 3, opacity: 0.5 },
          data: [
            [at(ms.low), i],
            [at(ms.high), i],
          ],
        })),
        {
          type: 'scatter' as const,
          symbolSize: 9,
          z: 4,
          data: sorted.map(({ ms }, i) => ({
            value: [at(ms.median), i],
            // Hollow: its interval reaches down to nothing.
            itemStyle:
              ms.low > LEAST
                ? { color, opacity: 1 }
                : { color: ink('ground'), borderColor: color, borderWidth: 2, opacity: 1 },
          })),
        },
        {
          type: 'bar' as const,
          xAxisIndex: 1,
          yAxisIndex: 1,
          barWidth: 9,
          itemStyle: { color },
          label: {
            show: true,
            position: 'right' as const,
            color: ink('ink'),
            fontSize: 12,
            formatter: '{b}',
          },
          data: sorted.map(({ bytes, chunk }) => ({
            value: bytes / 1000,
            name: bytes > 0 ? `${threeDigits(bytes / 1000)} ${chunk ?? ''}` : '0',
          })),
        },
      ],
    },
  );
  return `${standalone(svg)}\n`;
}
