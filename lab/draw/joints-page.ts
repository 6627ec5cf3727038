import { ammo } from '../engines/ammo.js';
import { iterated, ours } from '../engines/ours.js';
import { chains } from '../joints/errors.js';
import type { JointNumbers } from '../joints/numbers.js';
import { costTable, enduranceTable, errorTable } from '../joints/tables.js';
import type { Results, Row } from '../run/row.js';
import { caseChart } from './case-chart.js';
import { html, tableOf, type Markup } from './html.js';
import { themed } from './inks.js';
import { chart, page } from './page.js';

const ENGINES = [ours, iterated, ammo];

/** Our levels with the direct solve and without it, and raw Ammo. */
function charts(rows: readonly Row[]): Markup[] {
  const drawn = rows.filter(({ engine, level }) => engine === 'ammo' || level !== null);
  return chains.map((which) => {
    const of = (size: 'wide' | 'narrow') => themed(caseChart(which, drawn, size, ENGINES));
    return html`<h3>${which.name}</h3>
      ${chart(`${which.name}: error against time`, of('wide'), of('narrow'))}`;
  });
}

/** What the direct solve of joints gains and costs. */
export function jointsPage({ rows }: Results, numbers: JointNumbers): string {
  const { machine, date, endurance, costs } = numbers;
  return page(
    'Joints that do not stretch',
    html`<a href="index.html">All cases</a>`,
    html`<p>
        Joints are solved directly, in double precision, before each of Bullet's steps. Here is what
        that gains and costs beside Bullet's iterations. ${date}, ${machine}.
      </p>
      <h2>Error against time</h2>
      <p>
        Each chain is let go level; a reference in double precision says where its end should be.
        Both axes logarithmic: left is faster, down is nearer to the truth.
      </p>
      ${charts([...rows, ...numbers.iterated])}
      <p>
        Greatest error of the end in the first second, and in brackets the work per simulated
        second:
      </p>
      ${tableOf(errorTable(rows, numbers.iterated))}
      <h2>Gaps at the worst moment</h2>
      ${tableOf(enduranceTable(endurance))}
      <h2>What it costs</h2>
      <p>
        Microseconds per joint and step, on trees, in the least disturbed turn: all that the solve
        does, and what Bullet's own rows take, which is what its step takes longer than for the same
        bodies without joints. The ratio is the median over turns that both took one after the
        other. Nothing touches these bodies, so with the solve Bullet's rows rest: the last column
        is a whole step with the solve against one with Bullet's rows alone.
      </p>
      ${tableOf(costTable(costs))}`,
  );
}
