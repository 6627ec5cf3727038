// A shared text runs no code in the site's page, whatever its scene brings in.
import assert from 'node:assert/strict';
import type { Facts } from '../run.js';
import { BOXES } from '../scenes.js';
import { Tab } from '../tab.js';

const MARK = "window.top.ran = 'ran'";

const ATTACKS = [
  `<script>${MARK}</script>`,
  `<scene><transform onclick="${MARK}" onmouseover="${MARK}"><shape><box size="9 9 9"></box></shape></transform></scene>`,
  `<img src="x" onerror="${MARK}">`,
  `<svg onload="${MARK}"></svg>`,
  `<a href="javascript:${MARK}">press here</a>`,
  `<x3d onload="${MARK}" ondownloadsfinished="${MARK}"><scene></scene></x3d>`,
  `<scene><anchor url='"javascript:${MARK}"'><shape><box size="9 9 9"></box></shape></anchor></scene>`,
  `<scene><inline url="/attack.x3d"></inline></scene>`,
  `<iframe srcdoc="<script>${MARK}</script>"></iframe>`,
  `<scene><shape><appearance><movietexture url='"x.mpd"'></movietexture></appearance><box></box></shape></scene>`,
];

/** x3dom runs what stands in such attributes of a file that it brings in. */
const BROUGHT_IN = `<X3D><Scene><Transform onclick="${MARK}" onmouseover="${MARK}" onmousemove="${MARK}">
  <Shape><Box size="9 9 9"/></Shape></Transform></Scene></X3D>`;

export const harmless: Facts = {
  'nothing in a shared text runs, nor in a file that it brings in': async (browser, address) => {
    for (const attack of ATTACKS) {
      const tab = new Tab(await browser.newPage(), address);
      await tab.page.route('**/attack.x3d', (route) =>
        route.fulfill({ contentType: 'model/x3d+xml', body: BROUGHT_IN }),
      );
      await tab.goTo(`/playground.html#markup=${Buffer.from(attack).toString('base64url')}`);
      await tab.page.waitForTimeout(700);
      const { x, y, width, height } = (await tab.page.locator('iframe').boundingBox())!;
      await tab.page.mouse.move(x + width / 2, y + height / 2);
      await tab.page.mouse.move(x + width / 2 + 5, y + height / 2);
      await tab.page.mouse.click(x + width / 2, y + height / 2);
      const link = tab.scene.getByText('press here');
      if (await link.count()) await link.click();
      await tab.page.waitForTimeout(300);
      assert.equal(await tab.page.evaluate('window.ran'), undefined, attack);
      await tab.page.close();
    }
  },

  'a page that is saved holds nothing that was left out': async (browser, address) => {
    const tab = await Tab.open(
      browser,
      address,
      BOXES.replace(
        '<!-- a word -->',
        `<iframe srcdoc="${MARK}"></iframe><group onclick="${MARK}"></group>`,
      ),
    );
    await tab.started();
    const [saved] = await Promise.all([tab.page.waitForEvent('download'), tab.press('Download')]);
    const parts: Buffer[] = [];
    for await (const part of await saved.createReadStream()) parts.push(part as Buffer);
    assert.doesNotMatch(Buffer.concat(parts).toString(), /top\.ran/);
  },
};
