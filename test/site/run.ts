// The documentation site: it builds, its links lead somewhere, its search finds fields, axe finds nothing, nothing moves
// while a page arrives, what it says to copy runs, and so does each scene in it, the stories of its reference pages among
// them; each that is live is fit to be seen.
//   --built     the site as it lies there
import { parseArgs } from 'node:util';
import { chromium } from 'playwright';
import { CHROMIUM_ARGUMENTS, ensureChromium, WITHOUT_WEBGL } from '../../tools/test/browsers.js';
import { ARRIVAL_ARGUMENTS } from '../../tools/docs/arrival.js';
import { buildDocs, serveDocs } from '../../tools/docs/site.js';
import { inaccessible } from './checks/accessible.js';
import { arrivals, unsettled } from './checks/arriving.js';
import { miscopied } from './checks/copied.js';
import { deadLinks } from './checks/links.js';
import { pages, type Page } from './checks/pages.js';
import { menu, unpictured } from './checks/pictures.js';
import { notFound } from './checks/search.js';
import { wrong } from './checks/scenes.js';
import { scenes, stories, type Scene } from './checks/sources.js';

const PORT = 6206;

const { values: options } = parseArgs({ options: { built: { type: 'boolean' } } });

interface Result {
  passed: number;
  faults: string[];
}

const result = (count: number, faults: string[]): Result => {
  for (const fault of faults) console.error(`✗ ${fault}`);
  return { passed: Math.max(0, count - faults.length), faults };
};

/** Says how long it took: all of them together take minutes. */
async function checked(what: string, count: number, faults: Promise<string[]>): Promise<Result> {
  const start = performance.now();
  const all = result(count, await faults);
  console.log(
    `${what}: ${all.passed} of ${count}, ${((performance.now() - start) / 1000).toFixed(0)} s`,
  );
  return all;
}

/** By path, what the server answers beside the site's files. */
const madePages = (examples: Scene[]): Record<string, string> =>
  Object.fromEntries(
    examples.flatMap(({ path, html }) => (html === undefined ? [] : [[path, html]])),
  );

async function lookAt(all: Page[], examples: Scene[], address: string): Promise<Result[]> {
  const executablePath = await ensureChromium();
  const browser = await chromium.launch({ executablePath, args: CHROMIUM_ARGUMENTS });
  const plain = await chromium.launch({ executablePath, args: WITHOUT_WEBGL });
  const counting = await chromium.launch({ executablePath, args: ARRIVAL_ARGUMENTS });
  const shown = examples.filter(({ live }) => live);
  const pictured = menu();
  const results = [
    await checked('pictures of the menu', pictured.length, unpictured(plain, pictured)),
    await checked('the search', 1, notFound(plain, address)),
    await checked('how pages arrive', arrivals, unsettled(counting, address)),
    await checked('what is copied', 1, miscopied(browser, address)),
    await checked('axe', all.length, inaccessible(plain, address, all)),
  ];
  const seen = wrong(browser, address, examples);
  results.push(
    await checked(
      'scenes that run',
      examples.length,
      seen.then(({ running }) => running),
    ),
    await checked(
      'looks',
      shown.length,
      seen.then(({ looks }) => looks),
    ),
  );
  await Promise.all([browser, plain, counting].map((each) => each.close()));
  return results;
}

async function main(): Promise<number> {
  if (!options.built) await buildDocs();
  const all = pages();
  const examples = [...scenes(), ...stories()];
  const { port, close } = await serveDocs(PORT, madePages(examples));
  const results = [
    result(all.length, deadLinks(all)),
    ...(await lookAt(all, examples, `http://localhost:${port}`)),
  ];
  await close();
  const failed = results.reduce((sum, { faults }) => sum + faults.length, 0);
  const passed = results.reduce((sum, each) => sum + each.passed, 0);
  console.log(`${passed} passed, ${failed} failed`);
  return failed;
}

main().then(
  (failed) => process.exit(failed ? 1 : 0),
  (error) => {
    console.error(error);
    console.log('0 passed, 1 failed');
    process.exit(1);
  },
);
