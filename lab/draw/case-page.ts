import { floorOf, type Case } from '../case.js';
import { engines } from '../engines/index.js';
import type { Results, Row } from '../run/row.js';
import { caseChart } from './case-chart.js';
import { html, table, type Markup } from './html.js';
import { themed } from './inks.js';
import { errorOf, goalsOf, ladderOf, rowsOf, timeTo } from './judge.js';
import { milliseconds, power, quantity, stepOf } from './numbers.js';
import { chart, page } from './page.js';

export const fileOf = ({ id }: Case): string => `${id}.html`;

export const linkTo = (which: Case): Markup => html`<a href="${fileOf(which)}">${which.name}</a>`;

const settingOf = ({ level, step, iterations }: Row): string =>
  level ?? `${stepOf(step)}, ${iterations} it.`;

/** What it takes to come so near, engine by engine. */
function reached(which: Case, rows: readonly Row[]): Markup {
  const goals = goalsOf(which);
  const lines = [
    { name: 'our levels', rows: ladderOf(which, rows) },
    ...engines.map(({ id, name }) => ({
      name: id === 'ours' ? 'our free sweep' : name,
      rows: rowsOf(which, id, rows),
    })),
  ].filter((line) => line.rows.length > 0);
  return table(
    ['ms per simulated second to reach', ...goals.map((goal) => quantity(goal, which.unit))],
    lines.map((line) => [
      line.name,
      ...goals.map((goal) => {
        const row = timeTo(goal, line.rows);
        return row ? `${milliseconds(row.ms)} (${settingOf(row)})` : 'not reached';
      }),
    ]),
  );
}

const ladder = (which: Case, rows: readonly Row[]): Markup =>
  table(
    [
      'level',
      'step',
      'iterations',
      'error',
      'widest gap',
      'energy change',
      'ms per s',
      'contacts',
      'effects in use',
      'state',
    ],
    ladderOf(which, rows).map((row) => [
      row.level!,
      stepOf(row.step),
      String(row.iterations),
      quantity(row.error, row.unit),
      row.joints > 0 ? quantity(row.gap, 'm') : '–',
      row.energyChange === null ? '–' : `${power(row.energyChange)} J`,
      milliseconds(row.ms),
      String(row.contacts),
      row.effects.join(', ') || 'none',
      row.hash,
    ]),
  );

const data = (which: Case, rows: readonly Row[]): Markup =>
  table(
    ['engine', 'level', 'step', 'iterations', 'error', 'widest gap', 'ms per s', 'state'],
    engines
      .flatMap(({ id }) => rowsOf(which, id, rows))
      .map((row) => [
        engines.find(({ id }) => id === row.engine)!.name,
        row.level ?? '',
        stepOf(row.step),
        String(row.iterations),
        Number.isFinite(errorOf(row)) ? quantity(row.error, row.unit) : 'no end',
        row.joints > 0 ? quantity(row.gap, 'm') : '–',
        milliseconds(row.ms),
        row.hash,
      ]),
  );

function missing(which: Case, { notOffered }: Results): Markup {
  const lines = notOffered.filter((one) => one.case === which.id);
  if (lines.length === 0) return html``;
  const nameOf = (id: string) => engines.find((engine) => engine.id === id)!.name;
  return html`<h2>Not offered</h2>
    <ul>
      ${lines.map(({ engine, reason }) => html`<li>${nameOf(engine)} does not offer ${reason}.</li>`)}
    </ul>`;
}

/** Everything of one case. */
export function casePage(which: Case, all: readonly Case[], results: Results): string {
  const rows = results.rows.filter((row) => row.case === which.id);
  const at = all.indexOf(which);
  const link = (to: Case | undefined, word: string) =>
    to ? html`<a href="${fileOf(to)}">${word} ${to.name}</a>` : html``;
  return page(
    which.name,
    html`<a href="index.html">All cases</a
      ><a href="criteria.html">Criteria</a>${link(all[at - 1], '←')}${link(all[at + 1], '→')}`,
    html`<p>${which.says}</p>
      <p class="small">
        ${which.seconds} s simulated. The quantity itself: ${quantity(which.size, which.unit)}.
        Floor, under which an error counts as none:
        ${quantity(floorOf(which), which.unit)}.${which.horizon ? ` Chaotic: followed to its horizon of ${which.horizon} s.` : ''}
        Again: <code>npm run lab -- --case ${which.id}</code>
      </p>
      ${chart(`${which.name}: error against time`, themed(caseChart(which, rows, 'wide')), themed(caseChart(which, rows, 'narrow')))}
      <p class="small">
        Both axes logarithmic: left is faster, down is nearer to the truth. Solid lines: an engine's
        own number of iterations, its step from 1/60 to 1/1920 s; dashed: more iterations. Pale: the
        best that our engine does at any step and number of iterations.
      </p>
      <h2>Time to come near</h2>
      ${reached(which, rows)}
      <h2>Our levels</h2>
      ${ladder(which, rows)} ${missing(which, results)}
      <h2>All ${rows.length} runs</h2>
      <p class="small">
        Also in <a href="rows.csv">rows.csv</a> and <a href="rows.json">rows.json</a>.
      </p>
      ${data(which, rows)}`,
  );
}
