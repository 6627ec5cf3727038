import { html, nothing, svg, type TemplateResult } from '../lit.js';
import { ERRORS, type ErrorName } from './errors.js';
import { labelsOf } from './labels.js';
import { at, decades, ticks, type Scale } from './scale.js';

/** One level. */
export interface Dot {
  level: string;
  cost: number;
  error: number;
  /** In force now. */
  present: boolean;
}

export interface Drawing {
  dots: readonly Dot[];
  kind: ErrorName;
  /** Milliseconds per simulated second that the frame budget allows. */
  budget: number;
  width: number;
  height: number;
}

/** Pixels around the grid, for what is written there. */
const EDGE = { left: 80, right: 16, top: 28, bottom: 48 };

/** Pixels that the numbers of an axis need at least. */
const ROOM = { x: 44, y: 16 };

interface Axes {
  x: Scale;
  y: Scale;
  /** Errors of zero have no place on a logarithmic axis: they stand here, a decade below the least. */
  zero: number | undefined;
}

function axesOf({ dots, budget, width, height }: Drawing): Axes {
  const some = dots.map(({ error }) => error).filter((error) => error > 0);
  const { min, max } = decades(some.length > 0 ? some : [1e-6]);
  const zero = some.length < dots.length ? min / 10 : undefined;
  const costs = dots.map(({ cost }) => cost);
  return {
    x: {
      ...decades(budget > 0 ? [...costs, budget] : costs),
      from: EDGE.left,
      to: width - EDGE.right,
    },
    y: { min: zero ?? min, max, from: height - EDGE.bottom, to: EDGE.top },
    zero,
  };
}

function costAxis({ x, y }: Axes, height: number): TemplateResult {
  const lines = ticks(x, ROOM.x).map((value) => {
    const place = at(x, value);
    return svg`<line class="grid" x1=${place} x2=${place} y1=${y.from} y2=${y.to} />
      <text class="tick" text-anchor="middle" x=${place} y=${y.from + 18}>${String(value)}</text>`;
  });
  return svg`${lines}<line class="axis" x1=${x.from} x2=${x.to} y1=${y.from} y2=${y.from} />
    <text class="title" text-anchor="middle" x=${(x.from + x.to) / 2} y=${height - 8}>ms of work per simulated second</text>`;
}

function errorAxis({ x, y, zero }: Axes, kind: ErrorName): TemplateResult {
  const { axis, text } = ERRORS[kind];
  const lines = ticks(y, ROOM.y).map((value) => {
    const place = at(y, value);
    const isZero = zero !== undefined && value < zero * 1.01;
    return svg`<line class="grid" x1=${x.from} x2=${x.to} y1=${place} y2=${place} />
      <text class="tick" text-anchor="end" x=${x.from - 8} y=${place + 4}>${isZero ? '0' : text(value)}</text>`;
  });
  const middle = (y.from + y.to) / 2;
  return svg`${lines}<line class="axis" x1=${x.from} x2=${x.from} y1=${y.from} y2=${y.to} />
    <text class="title" text-anchor="middle" transform=${`translate(14 ${middle}) rotate(-90)`}>${axis}</text>`;
}

const BUDGET = 'frame budget';

function budgetLine({ x, y }: Axes, budget: number): TemplateResult {
  const place = at(x, budget);
  const side = place < (x.from + x.to) / 2 ? 'start' : 'end';
  return svg`<line class="budget" x1=${place} x2=${place} y1=${y.from} y2=${y.to} />
    <text class="budget" text-anchor=${side} x=${place} y=${y.to - 8}>${BUDGET}</text>`;
}

/** The level in force is the filled one. */
function levels({ x, y, zero }: Axes, dots: readonly Dot[]): TemplateResult {
  const places = dots.map(({ level, cost, error }) => ({
    name: level,
    x: at(x, cost),
    y: at(y, error > 0 ? error : zero!),
  }));
  const circles = dots.map(
    ({ present }, i) =>
      svg`<circle class=${present ? 'present' : ''} cx=${places[i]!.x} cy=${places[i]!.y} r=${present ? 8 : 5} />`,
  );
  const grid = { left: x.from, right: x.to, top: y.to, bottom: y.from };
  const names = labelsOf(places, grid).map(
    (label, i) =>
      svg`<text class=${dots[i]!.present ? 'level present' : 'level'} text-anchor=${label.anchor} x=${label.x} y=${label.y}>${label.text}</text>`,
  );
  const line = places.map((place) => `${place.x},${place.y}`).join(' ');
  return svg`<polyline class="levels" points=${line} />${circles}${names}`;
}

/** Error against cost, both logarithmic. What it shows is said beside it, in words and as a table. */
export function plot(drawing: Drawing): TemplateResult {
  const { dots, kind, budget, width, height } = drawing;
  const axes = axesOf(drawing);
  return html`<svg width=${width} height=${height} viewBox=${`0 0 ${width} ${height}`}>
    ${costAxis(axes, height)} ${errorAxis(axes, kind)}
    ${budget > 0 ? budgetLine(axes, budget) : nothing} ${levels(axes, dots)}
  </svg>`;
}
