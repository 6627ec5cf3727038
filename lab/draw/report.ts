import { readdirSync, rmSync, writeFileSync } from 'node:fs';
import { cases } from '../cases/index.js';
import { readContacts, type ContactNumbers } from '../contacts/numbers.js';
import { readJoints, type JointNumbers } from '../joints/numbers.js';
import type { Results } from '../run/row.js';
import { readStability, type StabilityNumbers } from '../stability/numbers.js';
import { casePage, fileOf } from './case-page.js';
import { contactsPage } from './contacts-page.js';
import { criteriaPage } from './criteria-page.js';
import { csvOf } from './csv.js';
import { indexPage } from './index-page.js';
import { standalone } from './inks.js';
import { jointsPage } from './joints-page.js';
import { stabilityPage } from './stability-page.js';
import { summaryChart } from './summary-chart.js';

/** Beside the numbers; the stories lead there. */
const FOLDER = new URL('../report/', import.meta.url);
const PICTURE = new URL('../../docs/pictures/accuracy.svg', import.meta.url);

const measuredCases = ({ rows }: Results) =>
  cases.filter(({ id }) => rows.some((row) => row.case === id));

/** Numbers beside the report's own: of pages that compare one of our solves with what Bullet does. */
export interface Beside {
  joints: JointNumbers;
  contacts: ContactNumbers;
  stability: StabilityNumbers;
}

export const readBeside = (): Beside => ({
  joints: readJoints(),
  contacts: readContacts(),
  stability: readStability(),
});

/** All pages, by the names of their files. */
export function pagesOf(
  results: Results,
  { joints, contacts, stability }: Beside,
): Map<string, string> {
  const known = measuredCases(results);
  return new Map([
    ['rows.csv', csvOf(results.rows)],
    ['index.html', indexPage(known, results)],
    ['criteria.html', criteriaPage(known, results)],
    ['joints.html', jointsPage(results, joints)],
    ['contacts.html', contactsPage(results, contacts)],
    ['stability.html', stabilityPage(stability)],
    ...known.map((which): [string, string] => [fileOf(which), casePage(which, known, results)]),
  ]);
}

export function drawPages(results: Results, beside: Beside): void {
  // Of cases that are called otherwise by now.
  for (const name of readdirSync(FOLDER))
    if (!name.endsWith('.json')) rmSync(new URL(name, FOLDER));
  for (const [name, text] of pagesOf(results, beside)) writeFileSync(new URL(name, FOLDER), text);
}

/** For the page on accuracy. */
export const pictureOf = (results: Results): string =>
  `${standalone(summaryChart(measuredCases(results), results.rows, 'wide'))}\n`;

export const drawPicture = (results: Results): void => writeFileSync(PICTURE, pictureOf(results));
