// npm run lab -- page: the paper's scenes in real pages, beside other libraries. Writes lab/report/pages.json cell by cell,
// and the pictures and tables of docs/pages.md. dist/ must be built; no network is needed.
//   --browser <name>   only in this one: chromium, firefox or webkit
//   --quick            few sizes, printed and not kept
//   --cell <cell>      only this scene of this size, as in boxes:500; printed and not kept
//   --threads          only what physics costs the page's own thread, there and in a worker, into lab/report/threads.json;
//                      with --cell that size alone, kept
//   --draw             measure nothing: pictures and tables of the numbers of last time
import { parseArgs } from 'node:util';
// @ts-expect-error plain JavaScript
import { BROWSERS } from '../../tools/docs/open-browser.js';
import type { AskedPages } from '../run/asked-browser.js';
import { drawPages } from './draw.js';
import { emptyPages, FRAMES, measureCell, measureStart, TURNS, WARM_UP } from './measure.js';
import { readPages, writePages, type BrowserPages, type PageNumbers } from './numbers.js';
import { asking, makePages } from './pages.js';
import { cellText, startText } from './text.js';
import { measureThreads } from './threads/index.js';
import { readThreads } from './threads/numbers.js';
import { COUNTS } from './threads/measure.js';

const { values: options } = parseArgs({
  options: {
    browser: { type: 'string' },
    quick: { type: 'boolean', default: false },
    cell: { type: 'string' },
    threads: { type: 'boolean', default: false },
    draw: { type: 'boolean', default: false },
  },
});

const ALL = { boxes: [10, 50, 100, 200, 500, 1000, 2000], links: [50, 100, 200, 500, 1000] };
const FEW = { boxes: [10, 100], links: [50] };

function sizes(): Record<string, readonly number[]> {
  if (!options.cell) return options.quick ? FEW : ALL;
  const [scene, count] = options.cell.split(':');
  return { [scene!]: [Number(count)] };
}

/** With and without a worker. */
const threadSizes = (): readonly number[] => (options.cell ? (sizes().boxes ?? []) : COUNTS);

const isKept = !options.quick && !options.cell;

const say = (line: string): void => void process.stderr.write(`${line}\n`);

/** What is found in a browser is kept at once. */
async function measure(name: string, pages: AskedPages, keep: (found: BrowserPages) => void) {
  const found = emptyPages();
  if (!options.cell) {
    const { found: start, version } = await asking(name, pages, measureStart);
    Object.assign(found, { start, version });
    say(startText(name, found));
  }
  for (const [scene, counts] of Object.entries(sizes()))
    for (const count of counts) {
      const { found: cell } = await asking(name, pages, (browser) =>
        measureCell(browser, scene, count),
      );
      found.cells.push(cell);
      say(cellText(name, cell));
      keep(found);
    }
}

function before(): PageNumbers['browsers'] {
  try {
    return readPages().browsers;
  } catch {
    return {}; // None was measured yet.
  }
}

const browsers = options.browser ? [options.browser] : (BROWSERS as string[]);

async function measureLibraries(pages: AskedPages): Promise<void> {
  const numbers = { warmUp: WARM_UP, turns: TURNS, frames: FRAMES, browsers: before() };
  for (const name of browsers)
    await measure(name, pages, (found) => {
      if (!isKept) return;
      numbers.browsers[name] = found;
      writePages(numbers);
    });
}
if (!options.draw) {
  const pages = await makePages();
  if (!options.threads) await measureLibraries(pages);
  if (options.threads || isKept) await measureThreads(browsers, pages, threadSizes());
}
if (isKept || options.threads) drawPages(readPages(), readThreads());
// A browser that was opened may take a while to go.
process.exit(0);
