import type { Costs, Percentiles, Phase } from '../../../physics-core/inside.js';
import { html, nothing, type TemplateResult } from '../lit.js';
import { milliseconds, whole } from './numbers.js';

const ROWS: readonly (readonly [Phase | 'total', string])[] = [
  ['step', 'Step'],
  ['read', 'Read poses'],
  ['write', 'Write poses'],
  ['events', 'Listeners'],
  ['total', 'Together'],
];
const COLUMNS = ['p50', 'p90', 'p99'] as const satisfies readonly (keyof Percentiles)[];

/** Milliseconds of main thread per frame, by phase. */
export const costs = (costs: Costs | undefined): TemplateResult =>
  html`<table part="costs">
    <caption>
      Milliseconds per frame${costs ? html`, last ${whole(costs.frames)} frames` : nothing}
    </caption>
    <thead>
      <tr>
        <th scope="col">Phase</th>
        ${COLUMNS.map((column) => html`<th scope="col">${column}</th>`)}
      </tr>
    </thead>
    <tbody>
      ${ROWS.map(
        ([phase, name]) =>
          html`<tr>
            <th scope="row">${name}</th>
            ${COLUMNS.map((column) => html`<td>${costs ? milliseconds(costs[phase][column]) : '–'}</td>`)}
          </tr>`,
      )}
    </tbody>
  </table>`;
