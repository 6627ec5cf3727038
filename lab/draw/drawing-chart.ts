import type { DrawingNumbers, Row } from '../drawing/numbers.js';
import { decades, legend, logAxis, svgOf } from './chart.js';
import { ink, inkOf, standalone } from './inks.js';
import { power } from './numbers.js';

const SIZE = { width: 860, height: 420 };

/** For docs/drawing.md: script per frame by the number of bodies. */
export function drawingPicture({ rows }: DrawingNumbers): string {
  const script = rows.filter(({ webgl }) => webgl === 'none');
  const line = (name: string, color: string, of: (row: Row) => number) => ({
    name,
    type: 'line' as const,
    symbolSize: 8,
    itemStyle: { color },
    lineStyle: { color, width: 2 },
    data: script.map((row) => [row.bodies, of(row)]),
  });
  const all = script.flatMap(({ plain, batched, three }) => [plain.ms, batched.ms, three.ms]);
  const svg = svgOf('drawing', SIZE, {
    backgroundColor: ink('ground'),
    grid: { left: 70, right: 30, top: 40, bottom: 60 },
    legend: legend(['one by one', 'in one call', 'three.js, InstancedMesh']),
    xAxis: {
      ...logAxis('bodies that move', 30, String),
      ...decades(script.map((row) => row.bodies)),
    },
    yAxis: { ...logAxis('script per frame, ms', 44, power), ...decades(all) },
    series: [
      line('one by one', inkOf('ammo'), ({ plain }) => plain.ms),
      line('in one call', inkOf('ours'), ({ batched }) => batched.ms),
      line('three.js, InstancedMesh', inkOf('rapier'), ({ three }) => three.ms),
    ],
  });
  return standalone(svg);
}
