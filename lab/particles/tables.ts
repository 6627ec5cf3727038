import { threeDigits } from '../draw/numbers.js';
import type { Table } from '../draw/table.js';
import type { Estimate } from '../statistics.js';
import { forms } from './forms.js';
import { libraryOf } from './libraries.js';
import type { PageRow, PageSide, ParticleNumbers, Spread } from './numbers.js';
import { nodeScenes } from './scenes.js';

const both = (spread: Spread | undefined): string =>
  spread ? `${threeDigits(spread.median)} (${threeDigits(spread.ninety)})` : '–';

const ratio = (estimate: Estimate | undefined): string =>
  estimate
    ? `${threeDigits(estimate.median)} (${threeDigits(estimate.low)} – ${threeDigits(estimate.high)})`
    : '–';

const nameOf = (scene: string): string => nodeScenes.find(({ id }) => id === scene)!.name;

/** A step in Node. */
export const nodeTable = ({ node }: Pick<ParticleNumbers, 'node'>): Table => ({
  head: ['', 'our step, ms', 'without the bodies’ own', 'Babylon.js', 'ours to it'],
  rows: node.rows.map(({ scene, sides, added, toBabylon }) => [
    nameOf(scene),
    both(sides.ours),
    both(added),
    both(sides.babylon),
    ratio(toBabylon),
  ]),
});

const nothing = ['–', '–', '–', '–'];

function cells(side: PageSide | string): string[] {
  if (typeof side === 'string') return [side, ...nothing];
  const { script, step, drawing, living, ours } = side;
  return [...[script, step, drawing].map(both), String(living ?? '–'), ratio(ours)];
}

const rowsOf = ({ form, sides }: PageRow): string[][] =>
  Object.entries(sides).map(([side, cost]) => [
    `${forms.find(({ id }) => id === form)!.name}: ${libraryOf(side).name}`,
    ...cells(cost),
  ]);

/** A frame of a page. */
export const pageTable = ({ chromium }: Pick<ParticleNumbers, 'chromium'>): Table => ({
  head: ['', 'script, ms', 'steps', 'drawing', 'living', 'our script to it'],
  rows: chromium.rows.flatMap(rowsOf),
});

/** In two sentences: a step, and a frame of sprites. */
export function summaryOf({ node, chromium }: ParticleNumbers): string {
  const steps = node.rows.map(
    ({ scene, sides }) => `${nameOf(scene)} ${threeDigits(sides.ours!.median)}`,
  );
  const sprites = chromium.rows.find(({ form }) => form === 'sprite')?.sides.ours;
  const frame =
    sprites && typeof sprites !== 'string'
      ? ` Drawing them as sprites takes ${threeDigits(sprites.drawing.median)} of script in a frame of Chromium.`
      : '';
  return `A step in Node: ${steps.join('; ')}.${frame}`;
}
