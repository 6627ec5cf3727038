// npm run lab:drawing: what it costs to draw many bodies, one by one and in one call, in one page load each, in turn.
// It needs dist/ and Chromium, and puts its table into docs/drawing.md and its chart beside it.
//   --sizes 100,1000   these numbers of bodies only
import { readFileSync, writeFileSync } from 'node:fs';
import { parseArgs } from 'node:util';
import { chromium } from 'playwright';
// @ts-expect-error plain JavaScript
import { CHROMIUM_ARGUMENTS, findChromium } from '../../tools/browsers.js';
// @ts-expect-error plain JavaScript
import { findFile } from '../../tools/static-files.js';
import { drawingPicture } from '../draw/drawing-chart.js';
import { MACHINE, today } from '../run/machine.js';
import { median } from '../run/median.js';
import { changes, frames, type Frames } from './in-page.js';
import { pageOf } from './scene.js';
import { tableOf, type DrawingNumbers, type Row } from './text.js';

const { values: options } = parseArgs({
  options: { sizes: { type: 'string', default: '100,500,1000,2000,5000' } },
});
const ROUNDS = 3;
const EDITS = 15;
const HOST = 'http://lab.test';
const NUMBERS = new URL('../report/drawing.json', import.meta.url);
const TEXT = new URL('../../docs/drawing.md', import.meta.url);
const PICTURE = new URL('../../docs/pictures/drawing.svg', import.meta.url);

const browser = await chromium.launch({
  executablePath: (await findChromium()) as string,
  args: CHROMIUM_ARGUMENTS as string[],
});

/** A page with so many bodies that move. */
async function open(count: number) {
  const page = await browser.newPage();
  await page.route(`${HOST}/**`, async (route) => {
    const { pathname } = new URL(route.request().url());
    if (pathname === '/') return route.fulfill({ contentType: 'text/html', body: pageOf(count) });
    const found = findFile('.', pathname) as { file: string; type: string } | undefined;
    if (!found) return route.fulfill({ status: 404 });
    return route.fulfill({ contentType: found.type, body: readFileSync(found.file) });
  });
  // tsx names functions by this helper, those that are sent to the page as well.
  await page.addInitScript('globalThis.__name = (one) => one');
  await page.goto(HOST);
  type Moving = Element & { world?: { time: number; stats: { batches?: number } } };
  await page.waitForFunction(
    () => {
      const { world } = document.querySelector<Moving>('#c')!;
      return !!world && world.time > 0.1 && world.stats.batches === 1;
    },
    null,
    { timeout: 120_000 },
  );
  return page;
}

const middle = (all: Frames[], of: (one: Frames) => number): number => median(all.map(of));
const script = ({ write, tick }: Frames): number => write + tick;

async function measure(bodies: number, stub: boolean): Promise<Row> {
  const page = await open(bodies);
  const { plain, batched } = await page.evaluate(frames, { stub, rounds: ROUNDS });
  await page.close();
  return {
    bodies,
    webgl: stub ? 'none' : 'software',
    plain: { ms: middle(plain, script), calls: middle(plain, ({ calls }) => calls) },
    batched: { ms: middle(batched, script), calls: middle(batched, ({ calls }) => calls) },
  };
}

async function edits(bodies: number) {
  const page = await open(bodies);
  const ms = await page.evaluate(changes, EDITS);
  await page.close();
  return { bodies, ms };
}

const numbers: DrawingNumbers = { machine: MACHINE, day: today(), rows: [], edits: [] };
for (const size of options.sizes.split(',').map(Number))
  for (const stub of [true, false]) {
    numbers.rows.push(await measure(size, stub));
    console.log(JSON.stringify(numbers.rows.at(-1)));
  }
for (const size of [50, 1000]) {
  numbers.edits.push(await edits(size));
  console.log(JSON.stringify(numbers.edits.at(-1)));
}
await browser.close();
writeFileSync(NUMBERS, `${JSON.stringify(numbers, null, 2)}\n`);
writeFileSync(PICTURE, drawingPicture(numbers));
const text = readFileSync(TEXT, 'utf8');
const table = `\n\n${tableOf(numbers)}\n\n`;
writeFileSync(TEXT, text.replace(/(?<=<!-- numbers -->)[^]*(?=<!-- end of numbers -->)/, table));
