// Scripts of a text run, are listed, and begin anew when they change; the site is out of their reach.
import assert from 'node:assert/strict';
import type { Facts } from '../run.js';
import { BOXES, COUNTING } from '../scenes.js';
import { Tab } from '../tab.js';

const begun = (tab: Tab): Promise<number> => tab.scene.evaluate('window.begun') as Promise<number>;

const lineOf = (text: string, part: string): number =>
  text.slice(0, text.indexOf(part)).split('\n').length;

/** What a script may try to take, and what comes of it. */
const REACH = [
  'parent.document.title',
  'top.document.body',
  'localStorage.length',
  'document.cookie',
  'indexedDB.open("x")',
  'top.location.href = "about:blank"',
];

export const scripts: Facts = {
  'scripts run as in a page of their own, and buttons beside the scene do what they say': async (
    browser,
    address,
  ) => {
    const tab = await Tab.open(browser, address, COUNTING);
    await tab.started();
    await tab.scene.waitForFunction(() => (window as any).fromModule > 0);
    await tab.scene.waitForFunction(
      () => Number(document.querySelector('output')!.textContent) > 3,
    );
    await tab.press('Pause');
    const before = (await tab.motions()).a!.linearVelocity[1]!;
    await tab.scene.getByRole('button', { name: 'Kick' }).click();
    assert.ok((await tab.motions()).a!.linearVelocity[1]! > before + 9);
    assert.deepEqual(await tab.told(), []);
    assert.deepEqual(tab.errors, []);
  },

  'they are listed by their lines, and a press leads there': async (browser, address) => {
    const tab = await Tab.open(browser, address, COUNTING);
    const list = tab.page.locator('.scripts');
    const [first, second] = ['<script>', '<script type'].map((tag) => lineOf(COUNTING, tag));
    assert.match(
      await list.innerText(),
      new RegExp(`^2 scripts run: line ${first}, line ${second}`),
    );
    await list.getByRole('button').last().click();
    assert.equal(await tab.page.evaluate(() => String(getSelection())), '<script type="module">');
    await tab.choose('Falling box');
    assert.ok(!(await list.isVisible()));
  },

  'an edit of the markup is done to the running scene, one attribute, and no script begins anew':
    async (browser, address) => {
      const tab = await Tab.open(browser, address, COUNTING);
      await tab.started();
      await tab.press('Pause');
      const [before, run] = [await tab.motions(), await begun(tab)];
      const counts = await tab.countsOf(() => tab.replace('mass="2"', 'mass="3"'));
      assert.deepEqual(counts, { bodies: 0, created: 0, patched: 1, destroyed: 0 });
      assert.deepEqual(await tab.motions(), before);
      assert.equal(await begun(tab), run);
    },

  'a script that changes begins anew, with the scene, once the typing has ended': async (
    browser,
    address,
  ) => {
    const tab = await Tab.open(browser, address, COUNTING);
    await tab.started();
    const run = await begun(tab);
    await tab.replace('[0, 20, 0]', '[0, 40, 0]');
    await tab.started();
    assert.notEqual(await begun(tab), run);
    await tab.press('Pause');
    const before = (await tab.motions()).a!.linearVelocity[1]!;
    await tab.scene.getByRole('button', { name: 'Kick' }).click();
    assert.ok((await tab.motions()).a!.linearVelocity[1]! > before + 19);
  },

  'an error in a script stands in words at its line, and goes with it': async (
    browser,
    address,
  ) => {
    const wrong = COUNTING.replace('let count = 0;', 'let count = 0;\n  nowhere.begin();');
    const tab = await Tab.open(browser, address, wrong);
    const [line] = await tab.waitForTold(1);
    assert.match(
      line!,
      new RegExp(`^Error in line ${lineOf(wrong, 'nowhere')}: .*nowhere is not defined`),
    );
    await tab.replace('nowhere.begin();', '');
    await tab.waitForMarks(0);
    assert.deepEqual(await tab.told(), []);
  },

  'a script reaches nothing of the site': async (browser, address) => {
    const tries = REACH.map(
      (each) => `try { ${each}; got.push(${JSON.stringify(each)}) } catch { }`,
    ).join('\n');
    const tab = await Tab.open(
      browser,
      address,
      `<x3d>${BOXES}</x3d><script>const got = window.got = [];\n${tries}</script>`,
    );
    await tab.started();
    assert.deepEqual(await tab.scene.evaluate('window.got'), []);
    assert.equal(await tab.scene.evaluate('origin'), 'null');
    assert.match(tab.page.url(), /playground/);
  },
};
