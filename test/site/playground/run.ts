// The playground as a person uses it, in the built site.
//   --built        the site as it lies there
//   --only <text>  facts with this in their names
import { parseArgs } from 'node:util';
import { chromium, type Browser } from 'playwright';
import { CHROMIUM_ARGUMENTS, ensureChromium } from '../../../tools/test/browsers.js';
import { buildSite, serveDocs } from '../../../tools/docs/site.js';
import { editing } from './facts/editing.js';
import { examples } from './facts/examples.js';
import { harmless } from './facts/harmless.js';
import { looks } from './facts/looks.js';
import { panel } from './facts/panel.js';
import { recordedRuns } from './facts/recorded.js';
import { scripts } from './facts/scripts.js';
import { telling } from './facts/telling.js';
import { wholePages } from './facts/whole-pages.js';

/** Throws where it does not hold. */
export type Fact = (browser: Browser, address: string) => Promise<unknown>;
export type Facts = Record<string, Fact>;

const PORT = 6306;

const { values: options } = parseArgs({
  options: { built: { type: 'boolean' }, only: { type: 'string', default: '' } },
});

const all: Facts = {
  ...{ ...editing, ...telling, ...scripts, ...panel },
  ...recordedRuns,
  ...{ ...wholePages, ...harmless, ...looks, ...examples },
};

async function look(facts: [string, Fact][], address: string): Promise<number> {
  const executablePath = await ensureChromium();
  const browser = await chromium.launch({ executablePath, args: CHROMIUM_ARGUMENTS });
  let failed = 0;
  for (const [name, fact] of facts) {
    const start = Date.now();
    try {
      await fact(browser, address);
      console.log(`✓ ${name} (${((Date.now() - start) / 1000).toFixed(1)} s)`);
    } catch (error) {
      failed++;
      console.error(`✗ ${name}\n${(error as Error).stack}`);
    }
    for (const page of browser.contexts().flatMap((context) => context.pages())) await page.close();
  }
  await browser.close();
  return failed;
}

async function main(): Promise<number> {
  if (!options.built) await buildSite();
  const { port, close } = await serveDocs(PORT);
  const facts = Object.entries(all).filter(([name]) => name.includes(options.only));
  const failed = await look(facts, `http://localhost:${port}`);
  await close();
  console.log(`${facts.length - failed} passed, ${failed} failed`);
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
