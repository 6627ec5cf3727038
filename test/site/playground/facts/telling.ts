// What is wrong stands at its line, and goes when it is mended.
import assert from 'node:assert/strict';
import type { Facts } from '../run.js';
import { BOXES } from '../scenes.js';
import { Tab } from '../tab.js';

const lineOf = (text: string, part: string): number =>
  text.slice(0, text.indexOf(part)).split('\n').length;

export const telling: Facts = {
  'a problem of the library stands at the line of its attribute, in its words, and goes': async (
    browser,
    address,
  ) => {
    const tab = await Tab.open(browser, address, BOXES);
    await tab.started();
    await tab.replace('mass="2"', 'mass="heavy"');
    await tab.waitForMarks(1);
    assert.deepEqual(await tab.markedLines(), [lineOf(BOXES, 'mass="2"')]);
    await tab.page.hover('.cm-lint-marker');
    const tip = await tab.page.locator('.cm-tooltip-lint').innerText();
    const [message] = await tab.scene.evaluate(() =>
      (window as any)
        .worldOf(document.querySelector('x3d'))
        .problems.map((each: any) => each.message),
    );
    assert.match(message, /mass/);
    assert.ok(tip.includes(message), `${tip} has ${message}`);
    await tab.replace('mass="heavy"', 'mass="3"');
    await tab.waitForMarks(0);
  },

  'a body outside a scene is marked where it stands': async (browser, address) => {
    const tab = await Tab.open(
      browser,
      address,
      '<x3d><scene></scene></x3d>\n<x3d-rigid-body></x3d-rigid-body>',
    );
    await tab.waitForMarks(1);
    assert.deepEqual(await tab.markedLines(), [2]);
    await tab.replace('\n<x3d-rigid-body></x3d-rigid-body>', '');
    await tab.waitForMarks(0);
  },

  'what is left out is marked where it stands': async (browser, address) => {
    const tab = await Tab.open(
      browser,
      address,
      BOXES.replace('id="a"', 'id="a" onclick="alert(1)"'),
    );
    await tab.waitForMarks(1);
    assert.deepEqual(await tab.markedLines(), [lineOf(BOXES, 'id="a"')]);
  },

  'tags, attributes and values are completed, with what the field is for': async (
    browser,
    address,
  ) => {
    const tab = await Tab.open(browser, address, '<scene>\n\n</scene>');
    const offer = tab.page.locator('.cm-tooltip-autocomplete');
    await tab.select('\n\n');
    await tab.page.keyboard.press('ArrowLeft');
    await tab.page.keyboard.press('ArrowDown');
    await tab.page.keyboard.type('<x3d-rigid-body-c');
    await offer.getByText('x3d-rigid-body-collection').waitFor();
    await tab.page.waitForTimeout(200);
    await tab.page.keyboard.press('Enter');
    await tab.page.keyboard.type(' accur');
    await offer.getByText('accuracy', { exact: true }).waitFor();
    await tab.page.waitForTimeout(200);
    assert.match(await tab.page.locator('.cm-completionInfo').innerText(), /Accuracy level/);
    await tab.page.keyboard.press('Enter');
    await offer.getByText('reference', { exact: true }).waitFor();
    await tab.page.keyboard.type('prec');
    await tab.page.waitForTimeout(200);
    await tab.page.keyboard.press('Enter');
    await tab.page.keyboard.press('ArrowRight');
    await tab.page.keyboard.type('>');
    assert.match(
      await tab.text(),
      /<x3d-rigid-body-collection accuracy="precise"><\/x3d-rigid-body-collection>/,
    );
  },

  'the nodes of x3dom and their fields are completed, too': async (browser, address) => {
    const tab = await Tab.open(browser, address, '<scene>\n<box></box>\n</scene>');
    const offer = tab.page.locator('.cm-tooltip-autocomplete');
    await tab.select('<box');
    await tab.page.keyboard.press('ArrowRight');
    await tab.page.keyboard.type(' si');
    await offer.getByText('size', { exact: true }).waitFor();
  },

  'a pointer over an attribute shows what it is for': async (browser, address) => {
    const tab = await Tab.open(browser, address, BOXES);
    await tab.page.getByText('mass', { exact: true }).first().hover();
    const doc = await tab.page.locator('.field-doc').innerText();
    assert.match(doc, /kg|[Mm]ass/);
  },
};
