import { floorOf, type Case } from '../case.js';
import { engines } from '../engines/index.js';
import type { Results } from '../run/row.js';
import { linkTo } from './case-page.js';
import { totals } from './criteria-page.js';
import { html, table } from './html.js';
import { themed } from './inks.js';
import { duel, errorOf, ladderOf, levelNames } from './judge.js';
import { milliseconds, quantity, times } from './numbers.js';
import { chart, page } from './page.js';
import { summaryChart } from './summary-chart.js';

function overview(cases: readonly Case[], { rows }: Results) {
  return table(
    ['case', 'floor', ...levelNames, 'standard takes', 'raw Ammo in that time', 'factor'],
    cases.map((which) => {
      const found = duel(which, 'ammo', rows);
      const ladder = ladderOf(which, rows);
      return [
        linkTo(which),
        quantity(floorOf(which), which.unit),
        ...levelNames.map((name) => {
          const row = ladder.find(({ level }) => level === name);
          return row ? quantity(errorOf(row), which.unit) : '–';
        }),
        found ? milliseconds(found.ms) : '–',
        found?.theirs === null ? 'not offered' : quantity(found?.theirs ?? null, which.unit),
        found?.factor ? times(found.factor) : '–',
      ];
    }),
  );
}

/** When and where; of a run that measured a few cases only, which. */
const measuredIn = ({ runs }: Results): string =>
  runs
    .map(({ date, machine, cases }, i) => {
      const which = i > 0 ? ` (${cases.join(', ')})` : '';
      return `${date}, ${machine}${which}`;
    })
    .join('; ');

export function indexPage(cases: readonly Case[], results: Results): string {
  const { rows } = results;
  return page(
    'What accuracy costs',
    html`<a href="criteria.html">Criteria</a><a href="joints.html">Joints</a
      ><a href="contacts.html">Contacts</a><a href="stability.html">Stability</a
      ><a href="rows.csv">rows.csv</a><a href="rows.json">rows.json</a>`,
    html`<p>
        ${cases.length} cases with a known answer, ${rows.length} runs: error against time at our
        levels, in a free sweep of step and iterations, and through other engines.
        ${measuredIn(results)}.
      </p>
      ${totals(cases, results)}
      ${chart(
        'Error at standard and the best of raw Ammo in the same time, case by case',
        themed(summaryChart(cases, rows, 'wide')),
        themed(summaryChart(cases, rows, 'narrow')),
      )}
      <h2>All cases</h2>
      ${overview(cases, results)}
      <h2>How it is measured</h2>
      <p>
        Every engine is told the same scene: bodies, joints, material, in SI units, resting switched
        off. References are closed forms or run in double precision at so small a step that halving
        it changes nothing. Errors are to the bit the same in every run;
        <code>npm run lab -- --quick</code> checks that.
      </p>
      <p>
        Times are of stepping alone, in one thread. The runs of a case take turns and are repeated,
        up to sixteen times or until a run has worked 0.15 s; its fastest repetition counts.
      </p>
      <ul>
        ${engines.map(({ name, says }) => html`<li><b>${name}</b>: ${says}</li>`)}
      </ul>
      <p>
        What an engine has no words for is not offered: it is said on the page of the case, and
        never replaced by something alike.
      </p>`,
  );
}
