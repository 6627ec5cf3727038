import { levels } from '../../physics-core/inside.js';
import type { StabilityCase } from '../stability/case.js';
import { stabilityCases } from '../stability/cases/index.js';
import { promises } from '../stability/levels.js';
import type { StabilityNumbers } from '../stability/numbers.js';
import { quantity } from './numbers.js';
import { html, type Markup } from './html.js';
import { ink, standalone } from './inks.js';

// The matrix in two columns of rows: what holds and what breaks, by a sign, a number and a colour; what is promised is bold.

const levelNames = levels.map(({ name }) => name);

/** Blue and orange: eyes that see few colours tell them apart. */
const [HOLDS, BREAKS] = ['ours', 'jolt'] as const;

/** Pixels. */
const [ROW, NAME, CELL, GAP] = [17, 110, 96, 24];
const WIDE = NAME + levelNames.length * CELL + GAP;
const HALF = Math.ceil(stabilityCases.length / 2);

const text = (x: number, y: number, fill: string, bold: boolean, words: string): Markup =>
  html`<text x="${x}" y="${y}" fill="${fill}" font-weight="${bold ? 700 : 400}">${words}</text>`;

function rowOf(which: StabilityCase, i: number, { cells }: StabilityNumbers): Markup[] {
  const x = i < HALF ? 0 : WIDE;
  const y = ROW * ((i % HALF) + 2);
  const row = levelNames.flatMap((level, column) => {
    const cell = cells[which.id]?.[level];
    if (!cell) return [];
    const { holds, measured, why } = cell;
    const number = why ? '' : quantity(measured, which.criterion.unit).trim();
    const at = x + NAME + column * CELL;
    const fill = ink(holds ? HOLDS : BREAKS);
    return [text(at, y, fill, promises(which, level), `${holds ? '✓' : '✗'} ${number}`)];
  });
  return [text(x, y, ink('ink'), false, which.id), ...row];
}

const headOf = (x: number): Markup[] =>
  levelNames.map((name, column) => text(x + NAME + column * CELL, ROW, ink('soft'), true, name));

/** For docs/stability.md. */
export function matrixPicture(numbers: StabilityNumbers): string {
  const [width, height] = [2 * WIDE, ROW * (HALF + 2)];
  const label = 'Hard cases down, levels across: a tick or a cross, and the number that is judged';
  return standalone(
    html`<svg
      xmlns="http://www.w3.org/2000/svg"
      viewBox="-8 0 ${width} ${height}"
      width="${width}"
      height="${height}"
      font-family="system-ui, sans-serif"
      font-size="11"
      role="img"
      aria-label="${label}"
    >
      <rect x="-8" width="${width}" height="${height}" fill="${ink('ground')}" />
      ${[...headOf(0), ...headOf(WIDE)]}${stabilityCases.flatMap((which, i) => rowOf(which, i, numbers))}
    </svg>`.text,
  );
}
