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

  'what is wrong stands in words under the editor, is announced, and leads to its place': async (
    browser,
    address,
  ) => {
    const tab = await Tab.open(browser, address, BOXES);
    await tab.started();
    await tab.replace('mass="2"', 'mass="heavy"');
    const [line] = await tab.waitForTold(1);
    assert.match(
      line!,
      new RegExp(`^(Error|Warning) in line ${lineOf(BOXES, 'mass="2"')}: .*mass`),
    );
    const list = tab.page.getByRole('list', { name: 'What is said of the text' });
    assert.equal(await list.getAttribute('aria-live'), 'polite');
    assert.ok(await list.isVisible());
    await tab.page.locator('.told button').press('Enter');
    const selected = await tab.page.evaluate(() => String(getSelection()));
    assert.equal(selected, 'mass="heavy"');
    await tab.replace('mass="heavy"', 'mass="3"');
    await tab.waitForMarks(0);
    assert.deepEqual(await tab.told(), []);
  },

  'a tag that is not finished hides no other word, and each stays at its line': async (
    browser,
    address,
  ) => {
    const wrong = BOXES.replace('mass="2"', 'mass="heavy"');
    const tab = await Tab.open(browser, address, wrong);
    await tab.waitForTold(1);
    await tab.replace('<scene>', '<scene>\n\n<transform');
    const told = await tab.waitForTold(2);
    assert.match(told[0]!, /^Error in line 3: This tag is not finished/);
    assert.match(told[1]!, new RegExp(`in line ${lineOf(wrong, 'heavy') + 2}: .*mass`));
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

  'a tag that is accepted is closed; its end is typed over': async (browser, address) => {
    const tab = await Tab.open(browser, address, '<scene>\n\n</scene>');
    const accept = async (typed: string, word: string) => {
      await tab.page.keyboard.type(typed);
      await tab.page.locator('.cm-tooltip-autocomplete').getByText(word, { exact: true }).waitFor();
      await tab.page.waitForTimeout(200);
      await tab.page.keyboard.press('Enter');
    };
    await tab.select('\n\n');
    await tab.page.keyboard.press('ArrowLeft');
    await tab.page.keyboard.press('ArrowDown');
    await accept('<transfo', 'transform');
    await tab.page.keyboard.type('>');
    await accept('<x3d-rigid-bo', 'x3d-rigid-body');
    await tab.page.keyboard.type(' fixed');
    await tab.page.keyboard.press('Escape');
    assert.equal(
      await tab.text(),
      '<scene>\n<transform><x3d-rigid-body fixed></x3d-rigid-body></transform>\n</scene>',
    );
  },

  'a line that is wrapped goes on below its own beginning': async (browser, address) => {
    const long = `    <shape class="${'word '.repeat(60)}"></shape>`;
    const tab = await Tab.open(browser, address, `<scene>\n${long}\n</scene>`);
    const lefts = await tab.page
      .locator('.cm-line')
      .nth(1)
      .evaluate((line) => {
        const range = document.createRange();
        range.selectNodeContents(line);
        const rects = [...range.getClientRects()].filter(({ width }) => width > 1);
        const rows = new Map<number, number>();
        for (const { top, left } of rows.size ? [] : rects)
          rows.set(Math.round(top), Math.min(left, rows.get(Math.round(top)) ?? Infinity));
        return { rows: [...rows.values()], edge: line.getBoundingClientRect().left };
      });
    const [, ...wrapped] = lefts.rows;
    assert.ok(wrapped.length > 1, 'it is wrapped');
    for (const left of wrapped) assert.ok(left - lefts.edge > 40, `${left - lefts.edge} pixels in`);
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
