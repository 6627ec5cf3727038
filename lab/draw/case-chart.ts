import { floorOf, type Case } from '../case.js';
import { engines } from '../engines/index.js';
import type { Engine } from '../engines/engine.js';
import type { Row } from '../run/row.js';
import { decades, inUnit, legend, logAxis, SIZES, svgOf, type Size } from './chart.js';
import { ink, inkOf } from './inks.js';
import { quantity } from './numbers.js';
import { errorOf, frontierOf, ladderOf, rowsOf } from './judge.js';

/** Told apart by their shapes too. */
export const SYMBOLS: Record<string, string> = {
  ours: 'circle',
  ammo: 'rect',
  'x-ite': 'triangle',
  cannon: 'diamond',
  rapier: 'roundRect',
  jolt: 'path://M0,0 L10,0 L5,9 Z',
  iterated: 'triangle',
};

const OUR_LEVELS = 'x3d-physics, levels';
const OUR_SWEEP = 'x3d-physics, free sweep';

interface Frame {
  which: Case;
  rows: readonly Row[];
  /** Errors below are drawn on the lower edge. */
  least: number;
  span: { min: number; max: number };
}

const dot = ({ least }: Frame, row: Row): [number, number] => [
  row.ms,
  Math.max(errorOf(row), least),
];

const drawn = (rows: readonly Row[]): Row[] => rows.filter(({ error }) => error !== null);

function line(frame: Frame, engine: Engine, rows: readonly Row[], type: 'solid' | 'dashed') {
  const color = inkOf(engine.id);
  return {
    name: engine.name,
    type: 'line' as const,
    symbol: SYMBOLS[engine.id],
    symbolSize: type === 'solid' ? 8 : 5,
    lineStyle: { color, width: 1.5, type },
    itemStyle: { color },
    data: drawn(rows).map((row) => dot(frame, row)),
  };
}

/**
 * A line per number of iterations; the engine's default one is drawn through. X_ITE's iterations are its steps, and levels
 * have each their own.
 */
function linesOf(frame: Frame, engine: Engine) {
  const rows = rowsOf(frame.which, engine.id, frame.rows);
  if (engine.id === 'x-ite' || rows[0]!.level !== null) return [line(frame, engine, rows, 'solid')];
  const counts = [...new Set(rows.map(({ iterations }) => iterations))];
  return counts.map((count, i) =>
    line(
      frame,
      engine,
      rows.filter(({ iterations }) => iterations === count),
      i === 0 ? 'solid' : 'dashed',
    ),
  );
}

const inkOfOurs = inkOf('ours');

const dots = (frame: Frame, rows: readonly Row[]) => rows.map((row) => dot(frame, row));

/** The best that we do at any step and number of iterations, and all that was tried. */
function ourSweep(frame: Frame) {
  const sweep = drawn(rowsOf(frame.which, 'ours', frame.rows));
  const look = { name: OUR_SWEEP, itemStyle: { color: inkOfOurs, opacity: 0.35 } };
  return [
    {
      ...look,
      type: 'line' as const,
      symbol: 'none',
      lineStyle: { color: inkOfOurs, width: 7, opacity: 0.25 },
      data: dots(frame, frontierOf(sweep)),
    },
    {
      ...look,
      type: 'scatter' as const,
      symbol: 'circle',
      symbolSize: 4,
      data: dots(
        frame,
        sweep.filter(({ level }) => level === null),
      ),
    },
  ];
}

/** Levels of a ladder that errs alike at all of them stand side by side: their names lean, so as not to hide each other. */
const FLAT = 3;

function isFlat(ladder: readonly Row[]): boolean {
  const errors = ladder.map(errorOf);
  return Math.max(...errors) < FLAT * Math.min(...errors);
}

const leaning = { position: 'bottom', align: 'right', rotate: 50, offset: [4, 2] } as const;
const beside = { position: 'left', offset: [0, 9] } as const;

const levelName = (row: Row, flat: boolean) => ({
  show: true,
  ...(flat ? leaning : beside),
  color: ink('ink'),
  fontSize: 12,
  formatter: row.level!,
  textBorderColor: ink('ground'),
  textBorderWidth: 3,
});

const ourLevels = (frame: Frame, ladder = drawn(ladderOf(frame.which, frame.rows))) => ({
  name: OUR_LEVELS,
  type: 'line' as const,
  symbol: 'circle',
  symbolSize: 12,
  z: 5,
  lineStyle: { color: inkOfOurs, width: 2.5 },
  itemStyle: { color: inkOfOurs },
  data: ladder.map((row) => ({
    value: dot(frame, row),
    label: levelName(row, isFlat(ladder)),
  })),
});

/** A level line from one edge to the other, named at its right end. */
function across({ span, which }: Frame, name: string, error: number, type: 'dotted' | 'solid') {
  const label = {
    show: true,
    position: 'top' as const,
    align: 'right' as const,
    color: ink('soft'),
    fontSize: 11,
    formatter: `${name} ${quantity(error, which.unit)}`,
  };
  return {
    type: 'line' as const,
    symbolSize: 1,
    lineStyle: { color: ink('soft'), width: 1.2, type },
    itemStyle: { color: ink('soft') },
    data: [{ value: [span.min, error] }, { value: [span.max, error], label }],
  };
}

/** Error against time, both logarithmic; `all`: the engines that are drawn. */
export function caseChart(
  which: Case,
  rows: readonly Row[],
  size: Size,
  all: readonly Engine[] = engines,
): string {
  const mine = drawn(rows.filter((row) => row.case === which.id));
  const lines = [which.singlePrecision, floorOf(which)];
  const { min: least } = decades([Math.min(...lines) / 10]);
  const span = decades(mine.map(({ ms }) => ms));
  const frame: Frame = { which, rows, least, span };
  const others = all.filter(({ id }) => id !== 'ours' && rowsOf(which, id, mine).length > 0);
  const swept = mine.some(({ engine, level }) => engine === 'ours' && level === null);
  const errors = mine.map((row) => Math.max(errorOf(row), least));
  return svgOf(`${which.id}-${size}`, SIZES[size], {
    legend: legend([
      OUR_LEVELS,
      ...(swept ? [{ name: OUR_SWEEP, icon: 'roundRect' }] : []),
      ...others.map(({ name }) => name),
    ]),
    grid: { left: 66, right: 20, top: size === 'wide' ? 56 : 100, bottom: 48 },
    xAxis: { ...logAxis('ms of work per simulated second', 30, String), ...span },
    yAxis: {
      ...logAxis(`error, ${which.unit}`, 50, inUnit(which.unit)),
      ...decades([...errors, ...lines]),
    },
    series: [
      across(frame, 'floor', floorOf(which), 'solid'),
      across(frame, 'single precision', which.singlePrecision, 'dotted'),
      ...others.flatMap((engine) => linesOf(frame, engine)),
      ...(swept ? ourSweep(frame) : []),
      ourLevels(frame),
    ],
  });
}
