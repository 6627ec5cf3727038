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
      const told: { severity: string; message: string }[] = await tab.scene.evaluate(() =>
        (window as any)
          .worldOf(document.querySelector('x3d'))
          .problems.map(({ severity, message }: any) => ({ severity, message })),
      );
      const isRemark = ({ severity }: { severity: string }) => severity === 'info';
      assert.deepEqual(
        told.filter((each) => !isRemark(each)),
        [],
        names[i + 1],
      );
      const marks = await tab.page.locator('.cm-lint-marker').count();
      assert.ok(marks <= told.filter(isRemark).length, `${names[i + 1]}: something is left out`);
    }
    assert.deepEqual(tab.errors, []);
  },
};
