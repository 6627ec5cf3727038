// Every example of the menu.
import assert from 'node:assert/strict';
import type { Facts } from '../run.js';
import { Tab } from '../tab.js';

export const examples: Facts = {
  'every example of the menu opens and runs without a problem': async (browser, address) => {
    const tab = await Tab.open(browser, address);
    const names = await tab.page.locator('.bar option').allInnerTexts();
    assert.ok(names.length > 30, `${names.length} examples`);
    for (let i = 0; i < names.length - 1; i++) {
      await tab.page.locator('.bar select').selectOption(String(i));
      await tab.started();
      await tab.page.waitForTimeout(300);
      const told = await tab.scene.evaluate(() =>
        (window as any)
          .worldOf(document.querySelector('x3d'))
          .problems // Of a slow machine.
          .filter((each: any) => each.code !== 'lag')
          .map((each: any) => each.message),
      );
      assert.deepEqual(told, [], names[i + 1]);
      assert.equal(await tab.page.locator('.cm-lint-marker').count(), 0, names[i + 1]);
    }
    assert.deepEqual(tab.errors, []);
  },
};
