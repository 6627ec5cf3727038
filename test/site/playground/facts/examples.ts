// Every example of the menu.
import assert from 'node:assert/strict';
import type { Facts } from '../run.js';
import { Tab } from '../tab.js';

export const examples: Facts = {
  'every example of the menu opens and runs without a problem': async (browser, address) => {
    const tab = await Tab.open(browser, address);
    const [, ...names] = await tab.page.locator('.bar option').allTextContents();
    assert.ok(names.length > 30, `${names.length} examples`);
    for (const name of names) {
      await tab.choose(name);
      await tab.started();
      await tab.page.waitForTimeout(300);
      const told: { severity: string; message: string }[] = await tab.scene.evaluate(() =>
        (window as any)
          .worldOf(document.querySelector('x3d'))
          .problems.map(({ severity, message }: any) => ({ severity, message })),
      );
      const isRemark = ({ severity }: { severity: string }) => severity === 'info';
      assert.deepEqual(
        told.filter((each) => !isRemark(each)),
        [],
        name,
      );
      const said = await tab.told();
      const isNew = (line: string) => !told.some(({ message }) => line.endsWith(message));
      assert.deepEqual(said.filter(isNew), [], `${name}: something is left out, or fails`);
    }
    assert.deepEqual(tab.errors, []);
  },

  'each scene of the gallery goes on while its light is edited, and is patched': async (
    browser,
    address,
  ) => {
    const tab = await Tab.open(browser, address);
    const names = await tab.page.locator('optgroup[label="Gallery"] option').allTextContents();
    assert.ok(names.length >= 16, `${names.length} scenes`);
    for (const name of names) {
      await tab.choose(name);
      await tab.started();
      await tab.scene.evaluate(() => {
        const x3d = document.querySelector('x3d')!;
        (window as any).before = [x3d, (window as any).worldOf(x3d)];
      });
      await tab.replace('shadowIntensity="0.45"', 'shadowIntensity="0.4"');
      const after = await tab.scene.evaluate(() => {
        const x3d = document.querySelector('x3d')!;
        const [element, world] = (window as any).before;
        return {
          isSame: element === x3d && world === (window as any).worldOf(x3d),
          light: x3d.querySelector('directionallight')!.getAttribute('shadowIntensity'),
        };
      });
      assert.deepEqual(after, { isSame: true, light: '0.4' }, name);
    }
    assert.deepEqual(tab.errors, []);
  },

  'no two examples have one name; the chosen one stays shown, and is in the address': async (
    browser,
    address,
  ) => {
    const tab = await Tab.open(browser, address);
    const names = await tab.page.locator('.bar option').allTextContents();
    assert.equal(new Set(names).size, names.length);
    const groups = await tab.page.locator('.bar optgroup').count();
    assert.ok(groups > 4, `${groups} groups`);
    await tab.choose('Falling box');
    const shown = () =>
      tab.page.locator('.bar select').evaluate((menu: any) => menu.selectedOptions[0].textContent);
    assert.equal(await shown(), 'Falling box');
    assert.match(tab.page.url(), /#example=falling-box$/);
    await tab.replace('mass="2"', 'mass="3"');
    assert.equal(await shown(), 'Falling box');
    await tab.page.reload();
    await tab.page.waitForSelector('[data-ready]');
    assert.equal(await shown(), 'Falling box');
  },

  'who comes for the first time finds many bodies that move': async (browser, address) => {
    const tab = await Tab.open(browser, address);
    await tab.started();
    assert.ok((await tab.counts()).bodies > 8);
    const { ball } = await tab.motions();
    await tab.scene.waitForTimeout(1500);
    assert.notDeepEqual((await tab.motions()).ball, ball);
  },
};
