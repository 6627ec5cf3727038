// What the scene costs, what its accuracy is, and which effects run because of what: beside it.
import assert from 'node:assert/strict';
import type { Facts } from '../run.js';
import { BOXES } from '../scenes.js';
import { Tab } from '../tab.js';

export const panel: Facts = {
  'the panel shows cost, accuracy, and effects with what they are there for; it stays with another scene':
    async (browser, address) => {
      const tab = await Tab.open(browser, address, BOXES);
      await tab.started();
      const button = tab.page.getByRole('button', { name: 'Look inside' });
      assert.equal(await button.getAttribute('aria-pressed'), 'false');
      await tab.press('Look inside');
      assert.equal(await button.getAttribute('aria-pressed'), 'true');
      const monitor = tab.scene.locator('x3d-physics-monitor');
      await monitor.getByText('Bodies').waitFor();
      // It is drawn when it comes into sight, which the monitor above it may keep it from.
      const chart = tab.scene.locator('x3d-accuracy-chart');
      await chart.scrollIntoViewIfNeeded();
      await chart.getByRole('button').first().waitFor();
      await tab.choose('A door that a motor opens and closes');
      await tab.scene
        .locator('x3d-physics-monitor')
        .getByText('"motor": axis1Torque')
        .first()
        .waitFor();
      await tab.press('Look inside');
      assert.equal(await tab.scene.locator('x3d-physics-monitor').count(), 0);
      assert.deepEqual(tab.errors, []);
    },
};
