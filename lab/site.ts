// npm run lab -- site: how the site's own pages arrive, by slow lines. Writes its table in docs/pages.md. The site must be
// built (npm run docs).
//   --print   prints and keeps nothing
import { readFileSync, writeFileSync } from 'node:fs';
import { parseArgs } from 'node:util';
import { chromium, type Browser } from 'playwright';
import { ensureChromium } from '../tools/test/browsers.js';
import { FOLDER, serveDocs } from '../tools/docs/site.js';
import { between } from './draw/between.js';
import { markdownOf, type Table } from './draw/table.js';
import { MACHINE, today } from './run/machine.js';
import { median } from './statistics.js';
import {
  ARRIVAL_ARGUMENTS,
  arrivalOf,
  VISITORS,
  type Arrival,
  type Visitor,
} from '../tools/docs/arrival.js';
import { OWN_PAGES } from '../tools/docs/own-pages.js';

const TEXT = new URL('../docs/pages.md', import.meta.url);
const PORT = 6240;
/** Each page is opened anew so many times. */
const TURNS = 3;
/** Milliseconds in which nothing comes: the engine compiles meanwhile, the scene begins. */
const QUIET = 3000;

const { values: options } = parseArgs({ options: { print: { type: 'boolean', default: false } } });

const seconds = (milliseconds: number): string => (milliseconds / 1000).toFixed(1);

function rowOf(what: string, visitor: Visitor, turns: readonly Arrival[]): string[] {
  const of = (key: 'bytes' | 'before' | 'files' | 'first' | 'largest' | 'shift') =>
    median(turns.map((turn) => turn[key]));
  return [
    `${what}, ${visitor.name}`,
    (of('bytes') / 1000).toFixed(0),
    (of('before') / 1000).toFixed(0),
    of('files').toFixed(0),
    seconds(of('first')),
    seconds(of('largest')),
    of('shift').toFixed(3),
  ];
}

async function measured(browser: Browser, address: string): Promise<Table> {
  const rows: string[][] = [];
  for (const { path, what } of OWN_PAGES)
    for (const visitor of VISITORS) {
      const turns: Arrival[] = [];
      const site = { address, folder: FOLDER };
      while (turns.length < TURNS)
        turns.push(await arrivalOf(browser, site, path, visitor, { quiet: QUIET, slow: true }));
      rows.push(rowOf(what, visitor, turns));
      console.error([...rows.at(-1)!, ...turns[0]!.moved].join('  '));
    }
  const head = ['', 'kB', 'before a word', 'files', 'first word, s', 'largest, s', 'layout shift'];
  return { head, rows };
}

async function main(): Promise<void> {
  const { port, close } = await serveDocs(PORT);
  const executablePath = await ensureChromium();
  const browser = await chromium.launch({ executablePath, args: ARRIVAL_ARGUMENTS });
  const table = markdownOf(await measured(browser, `http://localhost:${port}`));
  const conditions = `Medians of ${TURNS}, ${today()}, Chromium ${browser.version()}: ${MACHINE}.`;
  await browser.close();
  await close();
  const text = `${conditions}\n\n${table}`;
  if (options.print) console.log(text);
  else writeFileSync(TEXT, between(readFileSync(TEXT, 'utf8'), 'own pages', text));
}

await main();
