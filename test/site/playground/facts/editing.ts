// What one types is done to the running scene, and nothing else is.
import assert from 'node:assert/strict';
import type { Facts } from '../run.js';
import { A, B, BOXES, C, NEW, PLAIN } from '../scenes.js';
import { Tab, type Counts, type Motion } from '../tab.js';

const NOTHING: Counts = { bodies: 0, created: 0, patched: 0, destroyed: 0 };

/** Everything but the named ones is where it was, as fast as it was. */
function assertSame(
  before: Record<string, Motion>,
  after: Record<string, Motion>,
  ...but: string[]
) {
  for (const name of Object.keys(before)) {
    if (!but.includes(name)) assert.deepEqual(after[name], before[name], name);
  }
}

/** Three boxes that have begun to fall, and stand. */
async function falling(browser: Parameters<Facts[string]>[0], address: string, markup = BOXES) {
  const tab = await Tab.open(browser, address, markup);
  await tab.runAndPause();
  return tab;
}

export const editing: Facts = {
  'undo in a text that was just opened takes nothing away': async (browser, address) => {
    const tab = await Tab.open(browser, address, BOXES);
    await tab.started();
    await tab.select('<scene>');
    for (const key of ['Control+z', 'Control+z']) await tab.page.keyboard.press(key);
    assert.equal(await tab.text(), BOXES);
    assert.equal((await tab.counts()).bodies, 4);
  },

  'undo after another example leads back to the text before, and its scene': async (
    browser,
    address,
  ) => {
    const tab = await Tab.open(browser, address, BOXES);
    await tab.choose('Falling box');
    await tab.select('<scene>');
    await tab.page.keyboard.press('Control+z');
    assert.equal(await tab.text(), BOXES);
    await tab.started();
    assert.equal((await tab.counts()).bodies, 4);
    await tab.page.keyboard.press('Control+z');
    assert.equal(await tab.text(), BOXES);
  },

  'mass typed from 2 to 3 is one edit, and everything keeps its pose and velocity': async (
    browser,
    address,
  ) => {
    const tab = await falling(browser, address);
    const before = await tab.motions();
    assert.ok(before.a!.linearVelocity[1]! < -1);
    const counts = await tab.countsOf(async () => {
      await tab.select('mass="2"');
      for (const key of ['ArrowRight', 'ArrowLeft', 'Backspace', '3'])
        await tab.page.keyboard.press(key);
    });
    assert.match(await tab.text(), /mass="3"/);
    // Without a digit in between the text has no mass to tell: the last valid one holds.
    assert.deepEqual(counts, { ...NOTHING, patched: 1 });
    assertSame(before, await tab.motions());
    assert.equal(await tab.scene.evaluate(() => (document.querySelector('#a') as any).mass), 3);
  },

  'the plain tags of X3D, in XML, are patched as well': async (browser, address) => {
    const tab = await falling(browser, address, PLAIN);
    const counts = await tab.countsOf(() => tab.replace('mass="2"', 'mass="3"'));
    assert.deepEqual(counts, { ...NOTHING, patched: 1 });
  },

  'a body added in the text is one body more, and leaves the others as they are': async (
    browser,
    address,
  ) => {
    const tab = await falling(browser, address);
    const before = await tab.motions();
    const counts = await tab.countsOf(() => tab.replace(B, `${NEW}\n${B}`));
    assert.equal(counts.bodies, 1);
    assert.equal(counts.destroyed, 0);
    const after = await tab.motions();
    assertSame(before, after);
    assert.deepEqual(after.new!.position, [4, 4, 0]);
  },

  'a body removed from the text is one body less; undo brings it back': async (
    browser,
    address,
  ) => {
    const tab = await falling(browser, address);
    const before = await tab.motions();
    const removed = await tab.countsOf(() => tab.replace(B, ''));
    assert.equal(removed.bodies, -1);
    assert.equal(removed.created, 0);
    assertSame(before, await tab.motions(), 'b');
    const undone = await tab.countsOf(() => tab.page.keyboard.press('Control+z'));
    assert.equal(undone.bodies, 1);
    assert.equal(undone.destroyed, 0);
    assert.equal(await tab.text(), BOXES);
    assertSame(before, await tab.motions(), 'b');
  },

  'of bodies in another order only the one that moved is touched, and it keeps its motion': async (
    browser,
    address,
  ) => {
    const tab = await falling(browser, address);
    const before = await tab.motions();
    await tab.scene.evaluate(() => {
      (window as any).kept = [...document.querySelectorAll('x3d-rigid-body')];
    });
    const counts = await tab.countsOf(() => tab.replace(`${A}\n${B}\n${C}`, `${C}\n${A}\n${B}`));
    assert.equal(counts.bodies, 0);
    assert.ok(counts.created <= 2, `${counts.created} made`);
    assertSame(before, await tab.motions());
    const same = await tab.scene.evaluate(() =>
      (window as any).kept.every((body: Element) => body.isConnected),
    );
    assert.ok(same, 'the elements are the same');
  },

  'another name for a body makes no other body': async (browser, address) => {
    const tab = await falling(browser, address);
    const before = await tab.motions();
    const counts = await tab.countsOf(() => tab.replace('id="a"', 'id="z"'));
    assert.deepEqual({ ...counts, patched: 0 }, NOTHING);
    const after = await tab.motions();
    assert.deepEqual(after.z, before.a);
  },

  'a tag half typed changes nothing, is marked, and the scene goes on': async (
    browser,
    address,
  ) => {
    const tab = await falling(browser, address);
    const counts = await tab.countsOf(async () => {
      await tab.replace('  <!-- a word -->', '  <transform translation="1');
      await tab.waitForMarks(1);
    });
    assert.deepEqual(counts, NOTHING);
    const time = () =>
      tab.scene.evaluate(() => (window as any).worldOf(document.querySelector('x3d')).time);
    const before = await time();
    await tab.press('Go on');
    await tab.page.waitForTimeout(500);
    assert.ok((await time()) > before);
    await tab.page.keyboard.press('Control+z');
  },

  'a hundred keystrokes in a comment do nothing, in a colour they rebuild nothing': async (
    browser,
    address,
  ) => {
    const tab = await falling(browser, address);
    const words = await tab.countsOf(async () => {
      await tab.select('a word');
      await tab.page.keyboard.type('x'.repeat(50) + ' <b> " '.repeat(8));
    });
    assert.deepEqual(words, NOTHING);
    const colours = await tab.countsOf(async () => {
      await tab.select('0.8 0.2 0.1');
      await tab.page.keyboard.type('0.1 0.9 0.5 '.repeat(5));
    });
    assert.deepEqual(colours, NOTHING);
    assert.match(await tab.text(), /diffuseColor="(0.1 0.9 0.5 ){5}"/);
  },

  'what the library writes is not undone by an edit elsewhere': async (browser, address) => {
    const tab = await falling(browser, address);
    await tab.scene.evaluate(() =>
      document.querySelector('transform')!.setAttribute('translation', '-2 9 0'),
    );
    const { a } = await tab.motions();
    assert.equal(a!.position[1], 9);
    await tab.replace('mass="2"', 'mass="3"');
    assert.equal((await tab.motions()).a!.position[1], 9);
  },

  'an attribute of x3dom that goes has its default again, and can come back': async (
    browser,
    address,
  ) => {
    const tab = await falling(browser, address);
    const drawn = () =>
      tab.scene.evaluate(() => {
        const { _vf } = (document.querySelector('#a')!.parentElement!.querySelector('box') as any)
          ._x3domNode;
        return String(_vf.size);
      });
    const counts = await tab.countsOf(async () => {
      await tab.replace('<box size="1 1 1">', '<box>');
      await tab.scene.waitForTimeout(100);
      assert.equal(await drawn(), '2 2 2');
      await tab.replace('<box>', '<box size="3 3 3">');
      await tab.scene.waitForTimeout(100);
      assert.equal(await drawn(), '3 3 3');
    });
    assert.equal(counts.bodies, 0);
  },

  'a translation typed moves that body alone': async (browser, address) => {
    const tab = await falling(browser, address);
    const before = await tab.motions();
    await tab.replace('translation="-2 4 0"', 'translation="-2 6 0"');
    const after = await tab.motions();
    assertSame(before, after, 'a');
    assert.deepEqual(after.a!.position, [-2, 6, 0]);
  },
};
