// What `npm start` opens: the stories build, the first page shows a scene that moves, and the files that it leads to are
// there; stories fill their frames, with controls only where there are any. dist/ must be built.
//   --built     as they lie in the built site
/* global document, fetch, requestAnimationFrame */
import assert from 'node:assert/strict';
import { chromium } from 'playwright';
import { CHROMIUM_ARGUMENTS, ensureChromium } from './browsers.js';
import { FOLDER } from '../docs/site.js';
import { serve } from '../docs/static-files.js';
import { buildStories, STORIES } from '../docs/stories.js';

const PORT = 6106;
const WIDE = { width: 1280, height: 800 };
const PHONE = { width: 390, height: 800 };

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

/** A story in the frame of all stories. */
async function open(page, id) {
  await page.goto(id ? `/?path=/story/${id}` : '/');
  const story = page.frameLocator('#storybook-preview-iframe');
  await story.locator('x3d canvas').first().waitFor({ state: 'attached', timeout: 60_000 });
  return { story, frame: page.frames().find((each) => each.url().includes('iframe.html')) };
}

const scene = (story) => story.locator('x3d').first().boundingBox();
const panel = (page) => page.locator('#storybook-panel-root');

const FACTS = {
  'the first page says what this is, its scene moves, and what it leads to is there': async (
    page,
  ) => {
    const { frame } = await open(page);
    assert.match(await frame.locator('#storybook-root h1').innerText(), /x3d-physics/);
    assert.ok((await frame.evaluate(way)) > 0.01, 'a body moves');
    const { count, dead } = await frame.evaluate(deadLinks);
    assert.ok(count >= 3, 'it leads to the report and to two scripts');
    assert.deepEqual(dead, []);
  },

  'a story without controls has no panel, and one with controls shows their defaults': async (
    page,
  ) => {
    await open(page, 'dragging--keyboard');
    assert.equal(await panel(page).isVisible(), false);
    await open(page, 'accuracy--auto');
    await panel(page)
      .getByRole('row', { name: /budget/ })
      .waitFor();
    const cells = panel(page)
      .getByRole('row', { name: /budget/ })
      .getByRole('cell');
    assert.match(await cells.nth(2).innerText(), /\d/);
  },

  'scenes are at least half as wide as their frame, on a phone nearly all of it': async (page) => {
    for (const id of ['accuracy--auto', 'looking-in--events', 'dragging--keyboard'])
      for (const [size, share] of [
        [WIDE, 0.5],
        [PHONE, 0.9],
      ]) {
        await page.setViewportSize(size);
        const { story } = await open(page, id);
        const frame = await page.locator('#storybook-preview-iframe').boundingBox();
        const { width } = await scene(story);
        assert.ok(width >= share * frame.width, `${id}: ${width} of ${frame.width}`);
      }
  },

  'the chart shows kept numbers before anybody measures, each level by name': async (page) => {
    const { story } = await open(page, 'accuracy--chart');
    await story.locator('x3d-accuracy-chart svg .level').nth(4).waitFor();
    const names = await story.locator('x3d-accuracy-chart svg .level').allTextContents();
    assert.deepEqual(names.toSorted(), ['fine', 'game', 'precise', 'reference', 'standard']);
  },

  'the slider beside the reference names its level, and says how far off that is': async (page) => {
    const { story } = await open(page, 'accuracy--beside-reference');
    assert.match(await story.locator('[data-value=level]').innerText(), /^game, 1\/60 s$/);
    await story.getByRole('slider').press('End');
    assert.match(await story.locator('[data-value=level]').innerText(), /^reference/);
    await story.locator('[data-value=drift]', { hasText: /\d/ }).waitFor();
  },

  'debug drawing has its legend beside it': async (page) => {
    const { story } = await open(page, 'looking-in--debug-drawing');
    await story.locator('x3d-physics-monitor [part=legend] li').nth(9).waitFor();
  },

  'two thousand bodies are drawn in few calls, and one by one when that is switched': async (
    page,
  ) => {
    const { frame } = await open(page, 'drawing--two-thousand-bodies');
    const told = (name) =>
      frame.waitForFunction(
        (value) => document.querySelector(`[data-value="${value}"]`).textContent.match(/^\d+/)?.[0],
        name,
        { timeout: 120_000 },
      );
    const drawsOf = async (kind) => Number(await (await told(`${kind} draws`)).jsonValue());
    const stats = () =>
      frame.evaluate(() => document.querySelector('x3d-rigid-body-collection').world.stats);
    assert.ok((await drawsOf('batched')) < 30);
    const { bodies, batches, drawsSaved } = await stats();
    assert.ok(bodies > 2000);
    // The floor looks like the bricks of clay.
    assert.deepEqual([batches, drawsSaved], [5, 1996]);
    await frame.locator('.switch input').press('Space');
    assert.ok((await drawsOf('plain')) > 2000);
    assert.equal((await stats()).drawsSaved, 0);
    await frame.locator('.switch input').press('Space');
    await frame.waitForFunction(
      () => document.querySelector('x3d-rigid-body-collection').world.stats.drawsSaved === 1996,
      null,
      { timeout: 120_000 },
    );
  },
};

/** One fact in a page of its own, where nothing fails to load. */
async function holds(browser, baseURL, fact) {
  const page = await browser.newPage({ viewport: WIDE, baseURL });
  const wrong = [];
  page.on('pageerror', (error) => wrong.push(error.message));
  page.on('response', (answer) => answer.status() >= 400 && wrong.push(answer.url()));
  await fact(page);
  assert.deepEqual(wrong, []);
  await page.close();
}

async function main() {
  const isBuilt = process.argv.includes('--built');
  if (!isBuilt) await buildStories();
  const { port, close } = await serve(isBuilt ? `${FOLDER}/stories` : STORIES, PORT);
  const executablePath = await ensureChromium();
  const browser = await chromium.launch({ executablePath, args: CHROMIUM_ARGUMENTS });
  let failed = 0;
  for (const [name, fact] of Object.entries(FACTS))
    await holds(browser, `http://localhost:${port}`, fact).catch((error) => {
      failed++;
      console.error(`✗ ${name}\n  ${error.message}`);
    });
  await browser.close();
  await close();
  console.log(`${Object.keys(FACTS).length - failed} passed, ${failed} failed`);
  return failed;
}

main().then(
  (failed) => process.exit(failed ? 1 : 0),
  (error) => {
    console.error(error.message);
    console.log('0 passed, 1 failed');
    process.exit(1);
  },
);
