import type { DrawingNumbers, RoomRow } from '../drawing/numbers.js';
import { decades, legend, logAxis, svgOf } from './chart.js';
import { ink, inkOf, standalone } from './inks.js';
import { power } from './numbers.js';

const SIZE = { width: 860, height: 420 };
/** Pixels: of the two panels beside each other. */
const [LEFT, GAP, WIDTH] = [64, 76, 345];

type Value = (row: RoomRow) => number;

const LINES: { name: string; color: string; panel: 0 | 1; of: Value }[] = [
  { name: 'physics', color: 'cannon', panel: 0, of: ({ batched }) => batched.physics },
  { name: 'drawn one by one', color: 'ammo', panel: 0, of: ({ plain }) => plain.drawing },
  { name: 'drawn in few calls', color: 'ours', panel: 0, of: ({ batched }) => batched.drawing },
  { name: 'drawn one by one', color: 'ammo', panel: 1, of: ({ plain }) => 1000 / plain.frame },
  {
    name: 'drawn in few calls',
    color: 'ours',
    panel: 1,
    of: ({ batched }) => 1000 / batched.frame,
  },
];

/** For docs/drawing.md: scene 3 of the paper, milliseconds of a frame's parts and frames per second, by its boxes. */
export function roomPicture({ room }: DrawingNumbers): string {
  const range = decades(room.map(({ boxes }) => boxes));
  const values = LINES.filter(({ panel }) => panel === 0).flatMap(({ of }) => room.map(of));
  const left = (panel: number): number => LEFT + panel * (WIDTH + GAP);
  const rates = decades(LINES.filter(({ panel }) => panel === 1).flatMap(({ of }) => room.map(of)));
  const svg = svgOf('drawing-room', SIZE, {
    backgroundColor: ink('ground'),
    legend: legend(['physics', 'drawn one by one', 'drawn in few calls']),
    grid: [0, 1].map((panel) => ({
      left: left(panel),
      top: 40,
      bottom: 60,
      width: WIDTH,
    })),
    xAxis: [0, 1].map((gridIndex) => ({ ...logAxis('boxes', 30, String), ...range, gridIndex })),
    yAxis: [
      { ...logAxis('script per frame, ms', 44, power), ...decades(values), gridIndex: 0 },
      { ...logAxis('frames per second', 44, power), ...rates, gridIndex: 1 },
    ],
    series: LINES.map(({ name, color, panel, of }) => ({
      name,
      type: 'line' as const,
      symbolSize: 8,
      itemStyle: { color: inkOf(color) },
      lineStyle: { color: inkOf(color), width: 2 },
      xAxisIndex: panel,
      yAxisIndex: panel,
      data: room.map((row) => [row.boxes, Math.max(0.01, of(row))]),
    })),
  });
  return standalone(svg);
}
