import { mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { cases } from '../cases/index.js';
import type { Results } from '../run/row.js';
import { casePage, fileOf } from './case-page.js';
import { criteriaPage } from './criteria-page.js';
import { csvOf } from './csv.js';
import { indexPage } from './index-page.js';
import { standalone } from './inks.js';
import { summaryChart } from './summary-chart.js';

const FOLDER = new URL('../report/', import.meta.url);
const ROWS = new URL('rows.json', FOLDER);
/** In the README. */
const PICTURE = new URL('../../docs/pictures/accuracy.svg', import.meta.url);

export const readReport = (): Results => JSON.parse(readFileSync(ROWS, 'utf8')) as Results;

/** One row per line, so that a new run shows what changed. */
const jsonOf = ({ rows, notOffered }: Results): string => {
  const lines = (list: readonly object[]) => list.map((one) => JSON.stringify(one)).join(',\n');
  return `{"rows":[\n${lines(rows)}\n],"notOffered":[\n${lines(notOffered)}\n]}\n`;
};

/** Everything in lab/report/, and the picture of the README. */
export function writeReport(results: Results): void {
  const known = cases.filter(({ id }) => results.rows.some((row) => row.case === id));
  rmSync(FOLDER, { recursive: true, force: true });
  mkdirSync(FOLDER, { recursive: true });
  const write = (name: string, text: string) => writeFileSync(new URL(name, FOLDER), text);
  write('rows.json', jsonOf(results));
  write('rows.csv', csvOf(results.rows));
  write('index.html', indexPage(known, results));
  write('criteria.html', criteriaPage(known, results));
  for (const which of known) write(fileOf(which), casePage(which, known, results));
  writeFileSync(PICTURE, `${standalone(summaryChart(known, results.rows, 'wide'))}\n`);
}
