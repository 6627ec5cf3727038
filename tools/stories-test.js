// What `npm start` opens: the stories build, the first page shows a scene that moves, and the files that it leads to are
// there. dist/ must be built.
/* global document, fetch, requestAnimationFrame */
import assert from 'node:assert/strict';
import { chromium } from 'playwright';
import { CHROMIUM_ARGUMENTS, ensureChromium } from './browsers.js';
import { buildStories, serveStories } from './stories.js';

const PORT = 6106;

/** Runs in the page: how far the fastest body goes within some frames, metres. */
async function way() {
  const bodies = [...document.querySelectorAll('x3d-rigid-body')];
  await bodies[0].world.ready;
  const places = () => bodies.map((body) => body.position);
  const before = places();
  for (let i = 0; i < 30; i++) await new Promise(requestAnimationFrame);
  const ways = places().map((place, k) => Math.hypot(...place.map((v, i) => v - before[k][i])));
  return Math.max(...ways);
}

/** Runs in the page: files that it leads to and that are not there. */
async function deadLinks() {
  const links = [...document.querySelectorAll('a[target=_blank], a[download]')];
  const answers = await Promise.all(links.map(async ({ href }) => [href, (await fetch(href)).ok]));
  return { count: links.length, dead: answers.filter(([, ok]) => !ok) };
}

async function main() {
  await buildStories();
  const { port, close } = await serveStories(PORT);
  const executablePath = await ensureChromium();
  const browser = await chromium.launch({ executablePath, args: CHROMIUM_ARGUMENTS });
  const page = await browser.newPage();
  const wrong = [];
  page.on('pageerror', (error) => wrong.push(error.message));
  page.on('response', (answer) => answer.status() >= 400 && wrong.push(answer.url()));
  await page.goto(`http://localhost:${port}/`);
  const story = page.frameLocator('iframe').first();
  await story.locator('x3d-rigid-body').first().waitFor({ state: 'attached', timeout: 60_000 });
  const frame = page.frames().find((each) => each.url().includes('iframe.html'));
  assert.match(await frame.locator('#storybook-root h1').innerText(), /x3d-physics/);
  assert.ok((await frame.evaluate(way)) > 0.01, 'a body moves');
  const { count, dead } = await frame.evaluate(deadLinks);
  assert.ok(count >= 3, 'it leads to the report and to two scripts');
  assert.deepEqual(dead, []);
  assert.deepEqual(wrong, []);
  await browser.close();
  await close();
}

main().then(
  () => {
    console.log('1 passed, 0 failed');
    process.exit(0);
  },
  (error) => {
    console.error(error.message);
    console.log('0 passed, 1 failed');
    process.exit(1);
  },
);
