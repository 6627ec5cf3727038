import { levels } from '../../physics-core/inside.js';
import type { Cell, StabilityCase } from '../stability/case.js';
import { stabilityCases, themes } from '../stability/cases/index.js';
import type { StabilityNumbers } from '../stability/numbers.js';
import { html, type Markup } from './html.js';
import { ink, standalone } from './inks.js';
import { power } from './numbers.js';

// How near each case comes to what it is allowed: a line over all levels, a dot at the default one, a cross where it breaks.
// Two columns, in themes; as wide as a page of the docs, and its words as large as those around it.

const levelNames = levels.map(({ name }) => name);

/** Blue and orange: eyes that see few colours tell them apart. */
const [HOLDS, BREAKS] = [ink('ours'), ink('jolt')] as const;

/** Pixels. */
const [ROW, NAME, PLOT, GAP, EDGE, FONT] = [20, 142, 262, 28, 12, 13];
const COLUMN = NAME + PLOT;
const WIDTH = 2 * (COLUMN + EDGE) + GAP;

/** Decades of what is allowed: what is left of them is as good as nothing, what is right of them is out of bounds. */
const [LEAST, MOST] = [-6, 2];

/** Shares of what is allowed that are named above a column. */
const TICKS = [-6, -4, -2, 0];

const at = (decade: number): number => NAME + ((decade - LEAST) / (MOST - LEAST)) * PLOT;

/** Of what is allowed, as a place in a column. */
function placeOf({ criterion: { most } }: StabilityCase, { holds, measured }: Cell): number {
  if (measured === 0) return at(LEAST);
  const decade = most > 0 && Number.isFinite(measured) ? Math.log10(measured / most) : Infinity;
  // What breaks by anything but its number stands right of the line, too.
  const [from, to] = holds ? [LEAST, 0] : [0.5, MOST];
  return at(Math.min(to, Math.max(from, decade)));
}

type Shape = (x: number, y: number) => Markup;

const dot: Shape = (x, y) => html`<circle cx="${x}" cy="${y}" r="4" fill="${HOLDS}" />`;

const cross: Shape = (x, y) =>
  html`<path d="M${x - 4} ${y - 4}l8 8m0 -8l-8 8" stroke="${BREAKS}" stroke-width="2" />`;

const text = (x: number, y: number, fill: string, words: string, more = ''): Markup =>
  html`<text x="${x}" y="${y}" fill="${fill}" class="${more}">${words}</text>`;

function rowOf(which: StabilityCase, { cells }: StabilityNumbers, y: number): Markup[] {
  const row = levelNames.flatMap((level) => {
    const cell = cells[which.id]?.[level];
    return cell ? [{ level, cell, x: Math.round(placeOf(which, cell)) }] : [];
  });
  const held = row.filter(({ cell }) => cell.holds);
  const name = text(0, y + 4, ink('ink'), which.id);
  const shown = held.find(({ level }) => level === 'standard') ?? held[0];
  const places = held.map(({ x }) => x);
  const line = `M${Math.min(...places)} ${y}H${Math.max(...places)}`;
  return [
    name,
    ...(shown
      ? [html`<path d="${line}" stroke="${HOLDS}" stroke-width="2" />`, dot(shown.x, y)]
      : []),
    ...row.filter(({ cell }) => !cell.holds).map(({ x }) => cross(x, y)),
  ];
}

type Line = string | StabilityCase;

/** Themes with their cases, one after the other; the second column begins with the theme that passes the middle. */
function columns(): [Line[], Line[]] {
  const blocks = Object.entries(themes).map(([theme, cases]): Line[] => [theme, ...cases]);
  const half = (stabilityCases.length + blocks.length) / 2;
  const [left, right]: [Line[], Line[]] = [[], []];
  for (const block of blocks)
    (left.length + block.length / 2 <= half ? left : right).push(...block);
  return [left, right];
}

const lineAt = (line: Line, numbers: StabilityNumbers, y: number): Markup[] =>
  typeof line === 'string' ? [text(0, y + 4, ink('ink'), line, 'theme')] : rowOf(line, numbers, y);

const tickNames: Record<number, string> = { [LEAST]: '10⁻⁶ or less', 0: 'allowed' };

/** The scale above, and its lines behind the rows. */
const scale = (height: number): Markup[] =>
  TICKS.flatMap((decade) => [
    text(at(decade), FONT, ink('soft'), tickNames[decade] ?? power(10 ** decade), 'tick'),
    html`<path
      d="M${at(decade)} ${ROW}V${height}"
      stroke="${decade ? ink('line') : ink('soft')}"
      stroke-dasharray="${decade ? 'none' : '4 3'}"
    />`,
  ]);

function columnOf(lines: Line[], i: number, numbers: StabilityNumbers, height: number): Markup {
  const rows = lines.flatMap((line, k) => lineAt(line, numbers, ROW * (k + 1.7)));
  return html`<g transform="translate(${EDGE + i * (COLUMN + GAP)} 8)">${scale(height)}${rows}</g>`;
}

const STYLE = `.theme { font-weight: 700 } .tick { text-anchor: middle }`;

/** For docs/stability.md. */
export function matrixPicture(numbers: StabilityNumbers): string {
  const both = columns();
  const height = ROW * (Math.max(...both.map(({ length }) => length)) + 1.5);
  const label =
    'Hard cases down: how much of what is allowed each comes to; a cross right of the dashed line breaks';
  const svg = html`<svg
    xmlns="http://www.w3.org/2000/svg"
    viewBox="0 0 ${WIDTH} ${height + 16}"
    width="${WIDTH}"
    height="${height + 16}"
    font-family="system-ui, sans-serif"
    font-size="${FONT}"
    role="img"
    aria-label="${label}"
  >
    <style>
      ${STYLE}
    </style>
    <rect width="${WIDTH}" height="${height + 16}" fill="${ink('ground')}" />
    ${both.map((lines, i) => columnOf(lines, i, numbers, height))}
  </svg>`;
  return standalone(svg.text);
}
