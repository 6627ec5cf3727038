// Out of the playground, and back into it.
import assert from 'node:assert/strict';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import type { Browser, Page } from 'playwright';
import type { Facts } from '../run.js';
import { BOXES, COUNTING, PLAIN } from '../scenes.js';
import { Tab } from '../tab.js';

/** How far the page's body falls, by file:. */
const fallen = `(async () => {
  const body = document.querySelector('x3d-rigid-body, rigidbody');
  const world = await X3DPhysics.worldOf(body).ready;
  world.paused = true;
  world.reset();
  world.advance(0.5);
  return world.node('a').get('position')[1];
})()`;

/** The graphics card's driver, and what a browser says of one that is not there. */
const OF_DRIVER = /GL Driver Message|GPU stall|swiftshader/i;

/** Saves the text into an empty folder, and opens it from there without a network. */
async function fromDisk(
  browser: Browser,
  address: string,
  markup: string,
  look: (page: Page) => Promise<void>,
): Promise<void> {
  const folder = mkdtempSync(join(tmpdir(), 'x3d-playground-'));
  try {
    const tab = await Tab.open(browser, address, markup);
    const [saved] = await Promise.all([tab.page.waitForEvent('download'), tab.press('Download')]);
    const file = join(folder, saved.suggestedFilename());
    await saved.saveAs(file);
    const context = await browser.newContext({ offline: true });
    const page = await context.newPage();
    const said: string[] = [];
    page.on('pageerror', ({ message }) => said.push(message));
    page.on('console', (line) => OF_DRIVER.test(line.text()) || said.push(line.text()));
    page.on('request', (request) => {
      if (/^(https?|file):/.test(request.url()) && !request.isNavigationRequest())
        said.push(`asks for ${request.url()}`);
    });
    await page.goto(pathToFileURL(file).href);
    await look(page);
    const LAG = /\[lag\]/;
    assert.deepEqual(
      said.filter((line) => !LAG.test(line)),
      [],
    );
    await context.close();
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}

const runsFromDisk =
  (markup: string): Facts[string] =>
  (browser, address) =>
    fromDisk(browser, address, markup, async (page) => {
      const height = (await page.evaluate(fallen)) as number;
      assert.ok(height > 2.6 && height < 2.9, `at ${height} m after half a second`);
    });

export const wholePages: Facts = {
  'a shared address opens elsewhere with the same text': async (browser, address) => {
    const tab = await Tab.open(browser, address, BOXES);
    await tab.page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
    await tab.replace('mass="2"', 'mass="7"');
    await tab.press('Share');
    await tab.page.getByText('Copied').waitFor();
    const copied = await tab.page.evaluate(() => navigator.clipboard.readText());
    assert.match(copied, /#shared=/);
    const elsewhere = new Tab(await browser.newPage(), address);
    await elsewhere.goTo(new URL(copied).pathname + new URL(copied).hash);
    assert.equal(await elsewhere.text(), BOXES.replace('mass="2"', 'mass="7"'));
  },

  'an address that was cut short says so, and a scene is there': async (browser, address) => {
    const tab = new Tab(await browser.newPage(), address);
    await tab.goTo('/playground.html#shared=q1YKSS0u');
    await tab.page.getByText('holds no markup that can be read').waitFor();
    await tab.started();
  },

  'another address in the same page opens its text': async (browser, address) => {
    const tab = await Tab.open(browser, address);
    const { hash } = new URL(tab.page.url());
    assert.equal(hash, '');
    await tab.page.evaluate(() => (location.hash = `#markup=${btoa('<scene></scene>')}`));
    await tab.page.waitForFunction(
      () => document.querySelector('.cm-content')!.textContent === '<scene></scene>',
    );
  },

  'an address of an example stays short, with edits far apart, and brings the same text': async (
    browser,
    address,
  ) => {
    const tab = await Tab.open(browser, address);
    await tab.choose('A car drives over two bumps');
    assert.ok((await tab.text()).length > 4000);
    await tab.replace('mass="400"', 'mass="500"');
    await tab.page.keyboard.press('Control+End');
    await tab.page.keyboard.insertText('\n<p>The end</p>');
    await tab.press('Share');
    await tab.page.waitForFunction(() => location.hash.includes('&edits='));
    const { href, hash } = new URL(tab.page.url());
    assert.match(hash, /^#example=a-car-drives-over-two-bumps&edits=/);
    assert.ok(href.length < 300, `${href.length} letters`);
    const elsewhere = new Tab(await browser.newPage(), address);
    await elsewhere.goTo(`/playground.html${hash}`);
    assert.equal(await elsewhere.text(), await tab.text());
  },

  'a link that holds the markup of an example leads to a short address': async (
    browser,
    address,
  ) => {
    const tab = await Tab.open(browser, address);
    await tab.choose('Falling box');
    const linked = await Tab.open(browser, address, await tab.text());
    assert.match(linked.page.url(), /#example=falling-box$/);
    const menu = linked.page.locator('.bar select');
    assert.equal(await menu.inputValue(), 'falling-box');
  },

  'the page that is saved runs from disk by itself, without a network and without a word':
    runsFromDisk(BOXES),
  'so does one that was written as X3D in XML': runsFromDisk(PLAIN),
  'its scripts run there, modules that name the package among them': (browser, address) =>
    fromDisk(browser, address, COUNTING, async (page) => {
      await page.waitForFunction(() => Number(document.querySelector('output')!.textContent) > 3);
      await page.waitForFunction('window.fromModule > 0');
    }),
};
