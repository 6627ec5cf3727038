// Out of the playground, and back into it.
import assert from 'node:assert/strict';
import { copyFileSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import type { Facts } from '../run.js';
import { BOXES, PLAIN } from '../scenes.js';
import { Tab } from '../tab.js';

const SCRIPTS = ['node_modules/x3dom/x3dom.js', 'dist/x3d-physics.single.js'];

/** How far the page's body falls, by file:. */
const fallen = `(async () => {
  const body = document.querySelector('x3d-rigid-body, rigidbody');
  const world = await X3DPhysics.worldOf(body).ready;
  world.paused = true;
  world.reset();
  world.advance(0.5);
  return world.node('a').get('position')[1];
})()`;

const runsFromDisk =
  (markup: string): Facts[string] =>
  async (browser, address) => {
    const folder = mkdtempSync(join(tmpdir(), 'x3d-playground-'));
    try {
      const tab = await Tab.open(browser, address, markup);
      await tab.started();
      const [saved] = await Promise.all([tab.page.waitForEvent('download'), tab.press('Download')]);
      const file = join(folder, saved.suggestedFilename());
      await saved.saveAs(file);
      for (const script of SCRIPTS) copyFileSync(script, join(folder, script.split('/').at(-1)!));
      assert.match(readFileSync(file, 'utf8'), /mass="2"/);
      const page = await browser.newPage();
      await page.goto(pathToFileURL(file).href);
      await page.waitForFunction('window.X3DPhysics');
      const height = (await page.evaluate(fallen)) as number;
      assert.ok(height > 2.6 && height < 2.9, `at ${height} m after half a second`);
    } finally {
      rmSync(folder, { recursive: true, force: true });
    }
  };

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

  'the page that is saved runs from disk, with a falling box': runsFromDisk(BOXES),
  'so does one that was written as X3D in XML': runsFromDisk(PLAIN),
};
