// npm test -- --only examples: each example is installed with the package as it is packed, checked, built and driven in
// Chromium. dist/ must be built.  --only react,vue: these alone
import { readdirSync } from 'node:fs';
import { parseArgs } from 'node:util';
import { chromium } from 'playwright';
import { CHROMIUM_ARGUMENTS, ensureChromium } from './browsers.js';
import { FACTS, quiet } from './examples/facts.js';
import { install, RUNS } from './examples/projects.js';

const { values: options } = parseArgs({ options: { only: { type: 'string' } } });

const PATIENCE = 30_000;
/** What is drawn without a graphics card is drawn faster. */
const SMALL = { width: 390, height: 640 };
const counts = { passed: 0, failed: 0 };

async function fact(name, check) {
  try {
    await check();
    counts.passed++;
    console.log(`  ✓ ${name}`);
    return true;
  } catch (error) {
    counts.failed++;
    console.log(`  ✗ ${name}\n    ${error.message}`);
    return false;
  }
}

/** A fact on a page of its own. What is said in the console has to be what the framework itself says always. */
async function onPage(browser, address, { says = [] }, check) {
  const page = await browser.newPage({ viewport: SMALL });
  page.setDefaultTimeout(PATIENCE);
  const messages = [];
  const hear = (text) => says.some((said) => text.includes(said)) || messages.push(text);
  page.on('pageerror', (error) => hear(error.message));
  page.on('console', (message) => /error|warning/.test(message.type()) && hear(message.text()));
  try {
    await page.goto(address);
    await page.locator('x3d canvas').waitFor();
    await check(page);
    await quiet(page, messages);
  } catch (error) {
    throw new Error([error.message, ...messages].join('\n    '), { cause: error });
  } finally {
    await page.close();
  }
}

async function drive(browser, { served, facts = FACTS, more = [], ...run }) {
  const { address, close } = await served();
  try {
    for (const [name, check] of [...facts, ...more])
      await fact(name, () => onPage(browser, address, run, (page) => check(page, address)));
  } finally {
    await close();
  }
}

const prepare = (example) =>
  fact(
    `${example} is installed, has its types right, what the guide says of it too, and is built`,
    () => install(example),
  );

async function main() {
  const chosen =
    options.only?.split(',') ??
    readdirSync('examples', { withFileTypes: true })
      .filter((entry) => entry.isDirectory())
      .map(({ name }) => name);
  const executablePath = await ensureChromium();
  const browser = await chromium.launch({ executablePath, args: CHROMIUM_ARGUMENTS });
  let next = prepare(chosen[0]);
  for (const [i, example] of chosen.entries()) {
    const start = Date.now();
    const there = await next;
    // Its pages leave some of two cores to what the next one needs.
    if (i + 1 < chosen.length) next = prepare(chosen[i + 1]);
    if (!there) continue;
    console.log(example);
    for (const [name, run] of Object.entries(RUNS[example])) {
      console.log(` ${name}`);
      await drive(browser, run).catch((error) => fact('is served', () => Promise.reject(error)));
    }
    console.log(`  ${((Date.now() - start) / 1000).toFixed(1)} s`);
  }
  await browser.close();
  console.log(`${counts.passed} passed, ${counts.failed} failed`);
  process.exit(counts.failed === 0 ? 0 : 1);
}

main().catch((error) => {
  console.error(error.message);
  console.log('0 passed, 1 failed');
  process.exit(1);
});
