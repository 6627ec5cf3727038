import { contactCases, contactCosts, contactErrors } from '../contacts/tables.js';
import type { ContactNumbers } from '../contacts/numbers.js';
import { engines } from '../engines/index.js';
import type { Results, Row } from '../run/row.js';
import { caseChart } from './case-chart.js';
import { linkTo } from './case-page.js';
import { html, tableOf, type Markup } from './html.js';
import { themed } from './inks.js';
import { chart, page } from './page.js';

/** One case for each: what stands, what leans, what rolls. */
const CHARTED = ['stack-20', 'stack-100-on-1', 'house-of-cards', 'roll-cylinders'];

const charts = (rows: readonly Row[]): Markup[] =>
  contactCases
    .filter(({ id }) => CHARTED.includes(id))
    .map((which) => {
      const of = (size: 'wide' | 'narrow') => themed(caseChart(which, rows, size, engines));
      return html`<h3>${linkTo(which)}</h3>
        ${chart(`${which.name}: error against time`, of('wide'), of('narrow'))}`;
    });

/** What the direct solve of contacts gains and costs. */
export function contactsPage({ rows }: Results, { machine, date, costs }: ContactNumbers): string {
  return page(
    'Contacts that hold',
    html`<a href="index.html">All cases</a>`,
    html`<p>
        What is in touch is solved directly, in double precision, within each of Bullet's steps.
        Here is what that gains and costs. Costs: ${date}, ${machine}.
      </p>
      <h2>What it gains</h2>
      <p>
        Greatest errors at our levels, and those of other engines with steps of 1/120 s, which are
        those of <i>standard</i>, and their own number of iterations:
      </p>
      ${tableOf(contactErrors(rows))} ${charts(rows)}
      <h2>What it costs</h2>
      <p>
        Milliseconds of a step at <i>standard</i>, all bodies awake, medians over turns that all
        three took one after the other: ours; ours where an author sets <i>iterations</i>, so that
        contacts are left to Bullet's; and Bullet's own step of the same scene, through none of our
        code.
      </p>
      ${tableOf(contactCosts(costs))}`,
  );
}
