import { levels } from '../../physics-core/inside.js';
import type { StabilityCase } from '../stability/case.js';
import { themes } from '../stability/cases/index.js';
import { promises } from '../stability/levels.js';
import type { CellRow, StabilityNumbers } from '../stability/numbers.js';
import { besideOthers, criterionOf, loadOf, promiseCount, wordsOf } from '../stability/table.js';
import { html, table, tableOf, type Markup } from './html.js';
import { page } from './page.js';

const levelNames = levels.map(({ name }) => name);

function rowOf(which: StabilityCase, row: CellRow | undefined): (string | Markup)[] {
  return [
    html`<span class="long"><b>${which.id}</b> ${which.says}</span>`,
    ...levelNames.map((level) => {
      const cell = row?.[level];
      if (!cell) return '–';
      const words = wordsOf(which, cell);
      const kinds = ['cell', cell.holds ? 'good' : 'bad'];
      if (promises(which, level)) kinds.push('promised');
      return html`<span class="${kinds.join(' ')}">${words}</span>`;
    }),
    criterionOf(which),
    loadOf(which),
  ];
}

/** Every hard case at every level. */
export function stabilityPage(numbers: StabilityNumbers): string {
  const { kept, broken } = promiseCount(numbers);
  return page(
    'What stays stable',
    html`<a href="index.html">All cases</a>`,
    html`<p>
        Hard cases down, our levels across: whether each holds, and the number that is judged. What
        is underlined is promised: ${kept} such cells hold, ${broken.length}
        break${broken.length > 0 ? `: ${broken.join(', ')}` : ''}. ${numbers.date},
        ${numbers.machine}.
      </p>
      ${Object.entries(themes).map(
        ([theme, cases]) =>
          html`<h2>${theme}</h2>
            ${table(
              ['case', ...levelNames, 'criterion', 'load'],
              cases.map((which) => rowOf(which, numbers.cells[which.id])),
            )}`,
      )}
      <h2>Beside other engines</h2>
      <p>With steps of 1/120 s and their own number of iterations, by the same criterion.</p>
      ${tableOf(besideOthers(numbers))}`,
  );
}
