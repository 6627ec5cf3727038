import { floorOf, type Case } from '../case.js';
import type { Results, Row } from '../run/row.js';
import { linkTo } from './case-page.js';
import { html, table, type Markup } from './html.js';
import {
  brokenRungs,
  cheapRungs,
  duel,
  errorOf,
  hardestDuel,
  isBehind,
  ladderOf,
  levelNames,
  type Duel,
} from './judge.js';
import { milliseconds, quantity, times } from './numbers.js';
import { page } from './page.js';

/** A case with what was judged of it. */
interface Verdict {
  which: Case;
  ladder: Row[];
  broken: string[];
  cheap: string[];
  duel: Duel | undefined;
  /** With the best of raw Ammo, Rapier and Jolt. */
  hardest: ReturnType<typeof hardestDuel>;
}

const verdictsOf = (cases: readonly Case[], { rows }: Results): Verdict[] =>
  cases.map((which) => ({
    which,
    ladder: ladderOf(which, rows),
    broken: brokenRungs(which, rows),
    cheap: cheapRungs(which, rows),
    duel: duel(which, 'ammo', rows),
    hardest: hardestDuel(which, rows),
  }));

/** Against raw Ammo: those that it offers and where we are not at our floor. */
const contested = (verdicts: readonly Verdict[]): Verdict[] =>
  verdicts.filter(({ duel: one }) => one && one.theirs !== null && one.ours > one.floor);

const ahead = ({ duel: one }: Verdict): boolean => one!.ours < one!.theirs!;

/** Ten times as near to the truth as raw Ammo, or more. */
const farAhead = (verdicts: readonly Verdict[]): Verdict[] =>
  verdicts.filter(({ duel: one }) => (one?.factor ?? 0) >= 10);

const mark = (good: boolean, text: string): Markup =>
  html`<span class="${good ? 'good' : 'bad'}">${text}</span>`;

/** What the whole lab comes to, one sentence per criterion. */
export function totals(cases: readonly Case[], results: Results): Markup {
  const verdicts = verdictsOf(cases, results);
  const count = (holds: (verdict: Verdict) => boolean) => verdicts.filter(holds).length;
  const falling = count(({ broken }) => broken.length === 0);
  const dearer = count(({ cheap }) => cheap.length === 0);
  const even = contested(verdicts);
  const won = even.filter(ahead).length;
  const far = farAhead(verdicts).length;
  const all = verdicts.length;
  const behind = count(isBeaten);
  const beyond = count(({ hardest }) => (hardest?.factor ?? 0) >= 10);
  return html`<ul>
    <li>
      ${mark(falling === all, `In ${falling} of ${all} cases no level errs more than the level before it (or both are under the floor).`)}
    </li>
    <li>
      ${mark(dearer === all, `In ${dearer} of ${all} cases each level costs more time than the level before it.`)}
    </li>
    <li>
      ${mark(won === even.length, `In ${won} of the ${even.length} cases in which standard is not at its floor it errs less than the best that raw Ammo reaches in the same time.`)}
    </li>
    <li>
      ${mark(far >= 8, `In ${far} of ${all} cases raw Ammo errs at least ten times as much as standard in the same time.`)}
    </li>
    <li>
      ${mark(behind === 0, `In ${all - behind} of ${all} cases none of raw Ammo, Rapier and Jolt errs less than standard in the same time (or standard is at its floor); in ${beyond} the best of them errs at least ten times as much.`)}
    </li>
  </ul>`;
}

const isBeaten = ({ hardest }: Verdict): boolean => hardest !== undefined && isBehind(hardest);

function rungs({ which, ladder, broken }: Verdict): Markup[] {
  return levelNames.map((name) => {
    const row = ladder.find(({ level }) => level === name);
    if (!row) return html`–`;
    const text = quantity(row.error, which.unit);
    if (broken.includes(name)) return mark(false, text);
    return errorOf(row) <= floorOf(which) ? html`<i>${text}</i>` : html`${text}`;
  });
}

function against({ which, duel: one }: Verdict): (string | Markup)[] {
  if (!one) return ['–', '–', '–'];
  if (one.theirs === null) return [milliseconds(one.ms), 'not offered', '–'];
  const good = one.ours <= one.floor || one.ours < one.theirs;
  return [
    milliseconds(one.ms),
    quantity(one.theirs, which.unit),
    mark(good, one.factor === Infinity ? '∞' : times(one.factor!)),
  ];
}

function hardest({ which, hardest: one }: Verdict): (string | Markup)[] {
  if (!one || one.theirs === null) return ['–', '–'];
  const factor = one.factor === Infinity ? '∞' : times(one.factor!);
  return [`${one.engine}, ${quantity(one.theirs, which.unit)}`, mark(!isBehind(one), factor)];
}

const losses = (verdicts: readonly Verdict[]): Markup[] =>
  verdicts
    .filter(isBeaten)
    .map(({ which }) => html`<li>${which.name}: ${which.behind ?? 'no cause named.'}</li>`);

const causes = (verdicts: readonly Verdict[]): Markup[] =>
  verdicts
    .filter(({ broken }) => broken.length > 0)
    .map(
      ({ which, broken }) =>
        html`<li>
          ${which.name}, ${broken.join(' and ')}: ${which.exception ?? 'no cause named.'}
        </li>`,
    );

export function criteriaPage(cases: readonly Case[], results: Results): string {
  const verdicts = verdictsOf(cases, results);
  const exceptions = causes(verdicts);
  const beaten = losses(verdicts);
  return page(
    'Criteria of the accuracy lab',
    html`<a href="index.html">All cases</a>`,
    html`${totals(cases, results)}
      <p>
        A case's floor is the larger of ten times what single precision alone leaves and 1/10000 of
        the quantity itself. An error under it counts as none (in italics).
      </p>
      <p>
        Raw Ammo's error in the time of <i>standard</i> is the best of its sweep up to that time;
        between two runs of the sweep, the straight line between them in the logarithmic chart.
        Where its cheapest run takes longer, it is given that one. The factor counts errors under
        the floor as at the floor.
      </p>
      ${table(
        [
          'case',
          'floor',
          ...levelNames,
          'cost rises',
          'time of standard',
          'raw Ammo then',
          'factor',
          'best of raw Ammo, Rapier, Jolt then',
          'factor',
        ],
        verdicts.map((verdict) => [
          linkTo(verdict.which),
          quantity(floorOf(verdict.which), verdict.which.unit),
          ...rungs(verdict),
          mark(verdict.cheap.length === 0, verdict.cheap.join(', ') || 'yes'),
          ...against(verdict),
          ...hardest(verdict),
        ]),
      )}
      ${
        exceptions.length > 0
          ? html`<h2>Levels that err more than the level before</h2>
              <ul>
                ${exceptions}
              </ul>`
          : html``
      }
      ${
        beaten.length > 0
          ? html`<h2>Where another engine errs less in the time of standard</h2>
              <ul>
                ${beaten}
              </ul>`
          : html``
      }`,
  );
}
