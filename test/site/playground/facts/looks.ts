// Buttons, keyboard, narrow and dark pages; nothing stays behind.
import assert from 'node:assert/strict';
import axe from 'axe-core';
import type { Facts } from '../run.js';
import { BOXES } from '../scenes.js';
import { Tab } from '../tab.js';

const time = (tab: Tab): Promise<number> =>
  tab.scene.evaluate(() => (window as any).worldOf(document.querySelector('x3d')).time);

const AXE = `axe.run('.x3d-playground', { iframes: false, resultTypes: ['violations'] }).then(({ violations }) =>
  violations.map(({ id, nodes }) => id + ' at ' + nodes.map(({ target }) => target.join(' ')).join(', ')))`;

export const looks: Facts = {
  'pause, step, go on and reset do what they say': async (browser, address) => {
    const tab = await Tab.open(browser, address, BOXES);
    await tab.runAndPause();
    const before = await time(tab);
    await tab.page.waitForTimeout(300);
    assert.equal(await time(tab), before);
    await tab.press('Step');
    assert.ok(Math.abs((await time(tab)) - before - 1 / 120) < 1e-9);
    await tab.replace('mass="2"', 'mass="5"');
    await tab.press('Reset');
    await tab.started();
    assert.equal(await time(tab), 0);
    assert.deepEqual((await tab.motions()).a!.position, [-2, 4, 0]);
    assert.equal(await tab.scene.evaluate(() => (document.querySelector('#a') as any).mass), 5);
    await tab.press('Go on');
    await tab.page.waitForTimeout(500);
    assert.ok((await time(tab)) > 0);
  },

  'Tab indents; after Escape it leaves the text, which says so while it has the focus': async (
    browser,
    address,
  ) => {
    const tab = await Tab.open(browser, address, BOXES);
    const word = tab.page.getByText('Escape, then Tab leaves the text');
    assert.ok(!(await word.isVisible()));
    await tab.select('<scene>');
    assert.ok(await word.isVisible());
    const described = tab.page.getByRole('textbox', { name: 'Markup of the scene' });
    assert.equal(await described.getAttribute('aria-describedby'), await word.getAttribute('id'));
    await tab.page.keyboard.press('Tab');
    assert.match(await tab.text(), /^\s+<scene>/);
    await tab.page.keyboard.press('Escape');
    // The frame has an origin of its own: the page does not always say that the focus is in it.
    const inScene = () => tab.scene.evaluate(() => document.activeElement!.nodeName);
    assert.equal(await inScene(), 'BODY');
    await tab.page.keyboard.press('Tab');
    assert.equal(await inScene(), 'CANVAS');
  },

  'axe finds nothing, in light and dark, wide and narrow; the text stands over the scene on a phone':
    async (browser, address) => {
      const tab = await Tab.open(browser, address, BOXES.replace('mass="2"', 'mass="heavy"'));
      await tab.waitForMarks(1);
      await tab.page.addScriptTag({ content: axe.source });
      for (const width of [1280, 390]) {
        await tab.page.setViewportSize({ width, height: 800 });
        for (const dark of [false, true]) {
          await tab.page.evaluate(
            (on) => document.documentElement.classList.toggle('dark', on),
            dark,
          );
          assert.deepEqual(await tab.page.evaluate(AXE), [], `${width} ${dark ? 'dark' : 'light'}`);
        }
      }
      const [text, scene] = await Promise.all([
        tab.page.locator('.cm-editor').boundingBox(),
        tab.page.locator('iframe').boundingBox(),
      ]);
      assert.ok(scene!.y >= text!.y + text!.height && scene!.height > 200);
      const wide = await tab.page.evaluate(() => document.documentElement.scrollWidth);
      assert.ok(wide <= 390, `${wide} pixels wide`);
    },

  'the scene is light or dark as the site is': async (browser, address) => {
    const tab = await Tab.open(browser, address, BOXES);
    const scheme = () =>
      tab.scene.evaluate(() => getComputedStyle(document.documentElement).colorScheme);
    for (const wanted of ['dark', 'light']) {
      const isDark = wanted === 'dark';
      await tab.page.evaluate(
        (on) => document.documentElement.classList.toggle('dark', on),
        isDark,
      );
      await tab.settled();
      assert.equal(await scheme(), wanted);
    }
  },

  'a page that is left leaves no world, no frame and no error behind': async (browser, address) => {
    const tab = await Tab.open(browser, address, BOXES);
    await tab.started();
    await tab.page.evaluate(() => {
      (window as any).beats = 0;
      addEventListener('message', ({ data }) => data === 'beat' && (window as any).beats++);
    });
    await tab.scene.evaluate(() =>
      document.addEventListener('afterstep', () => parent.postMessage('beat', '*')),
    );
    await tab.page.waitForFunction('window.beats > 0');
    await tab.page.getByRole('link', { name: 'x3d-physics', exact: true }).first().click();
    await tab.page.waitForFunction(() => !document.querySelector('.x3d-playground'));
    const beats = () => tab.page.evaluate('window.beats');
    const left = await beats();
    await tab.page.waitForTimeout(500);
    assert.equal(await beats(), left);
    assert.deepEqual(tab.errors, []);
  },
};
