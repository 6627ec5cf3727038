// What a scene did, kept, shared by an address or a file, and shown again.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import type { Browser } from 'playwright';
import { fileOf, LONGEST, withRuns } from '../../../../site/playground/run.js';
import { sharedHash } from '../../../../site/playground/address.js';
import { LIMIT } from '../../../../site/playground/packed.js';
import type { Facts } from '../run.js';
import { BOXES } from '../scenes.js';
import { Tab } from '../tab.js';

/** A box in the middle of the picture, at rest, for hands. */
const HELD = `<scene>
  <viewpoint position="0 0 8"></viewpoint>
  <transform translation="0 -1.5 0"><shape><box size="20 1 20"></box></shape><x3d-rigid-body fixed></x3d-rigid-body></transform>
  <transform><shape><box size="2 2 2"></box></shape><x3d-rigid-body id="box" draggable-body></x3d-rigid-body></transform>
</scene>`;

interface Hash {
  step: number;
  hash: string;
}

interface Run {
  x3dPhysicsRun: number;
  hashes: Hash[];
  calls: { method: string }[];
}

interface Kept {
  markup: string;
  runs: [Run];
}

interface Looked {
  from: number;
  at: number | undefined;
  hashes: Hash[];
}

/** What the scene's world has of a timeline. */
const looked = (tab: Tab): Promise<Looked | undefined> =>
  tab.scene.evaluate(() => {
    const { timeline } = (window as any).worldOf(document.querySelector('x3d'));
    return timeline && { from: timeline.from, at: timeline.at, hashes: timeline.hashes };
  });

const run = (tab: Tab): Promise<Run> =>
  tab.scene.evaluate(() =>
    JSON.parse(JSON.stringify((window as any).worldOf(document.querySelector('x3d')).exportRun())),
  );

const recordButton = (tab: Tab) => tab.page.getByRole('button', { name: 'Record', exact: true });

/** Begins to record, and stands still. */
async function recorded(browser: Browser, address: string, markup: string): Promise<Tab> {
  const tab = await Tab.open(browser, address, markup);
  await tab.started();
  await tab.press('Pause');
  await tab.press('Record');
  await tab.page.waitForSelector('[data-part=record][aria-pressed=true]');
  await tab.scene.waitForFunction(
    () => (window as any).worldOf(document.querySelector('x3d'))?.timeline,
  );
  return tab;
}

/** Steps by hand; `each` is done before each of them. */
const step = (tab: Tab, count: number, kicked: string): Promise<void> =>
  tab.scene.evaluate(
    ([steps, id]) => {
      const body = document.getElementById(String(id)) as any;
      for (let i = 0; i < Number(steps); i++) {
        body.applyImpulse([Math.sin(i) / 9, Math.cos(i * i) / 7, 0]);
        body.world.step(1);
      }
    },
    [count, kicked],
  );

/** Takes the box in the middle of the picture, and pulls. */
async function drag(tab: Tab): Promise<void> {
  const { x, y, width, height } = (await tab.page.locator('iframe').boundingBox())!;
  const [right, down] = [x + width / 2, y + height / 2];
  await tab.page.mouse.move(right, down);
  await tab.page.mouse.down();
  for (let i = 1; i <= 8; i++) await tab.page.mouse.move(right + 6 * i, down - 4 * i);
  await tab.scene.evaluate(() => (window as any).worldOf(document.querySelector('x3d')).step(130));
  await tab.page.mouse.up();
  await tab.scene.evaluate(() => (window as any).worldOf(document.querySelector('x3d')).step(50));
}

/** Shares, and answers what is saved. */
async function saved(tab: Tab): Promise<Kept> {
  const [file] = await Promise.all([tab.page.waitForEvent('download'), tab.press('Share')]);
  assert.equal(file.suggestedFilename(), 'scene-and-run.json');
  return JSON.parse(await readFile(await file.path(), 'utf8')) as Kept;
}

/** Of three boxes, too long for an address. */
async function long(browser: Browser, address: string): Promise<{ run: Run; kept: Kept }> {
  const tab = await recorded(browser, address, BOXES);
  await step(tab, 400, 'a');
  return { run: await run(tab), kept: await saved(tab) };
}

const fileNamed = (text: string) => ({
  name: 'a.json',
  mimeType: 'application/json',
  buffer: Buffer.from(text),
});

async function chosen(tab: Tab, text: string): Promise<void> {
  const [chooser] = await Promise.all([
    tab.page.waitForEvent('filechooser'),
    tab.page.getByRole('button', { name: 'Open run' }).press('Enter'),
  ]);
  await chooser.setFiles(fileNamed(text));
}

const waitUntilShown = (tab: Tab): Promise<unknown> =>
  tab.page.getByText('A recorded run: Play shows it').waitFor();

/** A scene that falls, and what it tells of a file or an address; it goes on all the same. */
async function refused(tab: Tab): Promise<string> {
  const [line, ...others] = await tab.waitForTold(1);
  assert.deepEqual(others, []);
  assert.equal(await looked(tab), undefined);
  assert.ok(!(await tab.page.getByRole('button', { name: 'Play' }).isVisible()));
  return line!;
}

export const recordedRuns: Facts = {
  'a short run is shared by an address, hands included, and is the same there, bit for bit': async (
    browser,
    address,
  ) => {
    const tab = await recorded(browser, address, HELD);
    await drag(tab);
    const then = await run(tab);
    assert.deepEqual(
      ['drag', 'move', 'end'].filter((name) => !then.calls.some(({ method }) => method === name)),
      [],
    );
    assert.equal(then.hashes.length, 3);
    await tab.press('Share');
    await tab.page.waitForURL(/&run=/);
    const url = tab.page.url();
    assert.ok(url.length <= LONGEST, `${url.length} letters`);
    const other = new Tab(await browser.newPage(), address);
    await other.goTo(url.slice(address.length));
    await waitUntilShown(other);
    assert.equal(await other.text(), HELD);
    assert.deepEqual((await looked(other))!.hashes, then.hashes);
    assert.deepEqual(await other.told(), []);
    assert.deepEqual([...tab.errors, ...other.errors], []);
  },

  'a long run is saved as a file, which is chosen or dropped, and is the same, bit for bit': async (
    browser,
    address,
  ) => {
    const { run: then, kept } = await long(browser, address);
    assert.ok((await withRuns(await sharedHash(kept.markup), kept.runs)).length > LONGEST);
    assert.equal(kept.markup, BOXES);
    const text = await fileOf(kept).text();
    const tab = await Tab.open(browser, address);
    await chosen(tab, text);
    await waitUntilShown(tab);
    assert.equal(await tab.text(), BOXES);
    assert.deepEqual((await looked(tab))!.hashes, then.hashes);
    for (const place of [tab.page.locator('.cm-content'), tab.scene.locator('body')]) {
      await tab.choose('Falling box');
      await place.evaluate((element, words) => {
        const dataTransfer = new DataTransfer();
        dataTransfer.items.add(new File([words], 'a.json', { type: 'application/json' }));
        element.dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true }));
      }, text);
      await waitUntilShown(tab);
      assert.equal(await tab.text(), BOXES);
      assert.deepEqual((await looked(tab))!.hashes, then.hashes);
    }
    assert.deepEqual(tab.errors, []);
  },

  'it stands at its beginning; Play shows it, Record goes on from where one looks': async (
    browser,
    address,
  ) => {
    const { kept } = await long(browser, address);
    const tab = await Tab.open(browser, address);
    await chosen(tab, await fileOf(kept).text());
    await waitUntilShown(tab);
    const { from, at } = (await looked(tab))!;
    assert.equal(at, from);
    assert.match(await tab.page.locator('[data-part=time]').innerText(), /^0\.0\d s$/);
    await tab.page.getByRole('button', { name: 'Play' }).press('Enter');
    await tab.scene.waitForFunction(
      (start) => (window as any).worldOf(document.querySelector('x3d')).timeline.at > start,
      from,
    );
    await tab.page.getByRole('button', { name: 'Hold' }).press('Enter');
    await tab.page.getByRole('button', { name: 'Play' }).waitFor();
    const held = (await looked(tab))!.at!;
    assert.ok(held > from);
    await tab.press('Look inside');
    await tab.scene.getByRole('slider', { name: 'Look at' }).waitFor();
    await tab.press('Pause');
    await recordButton(tab).press('Enter');
    await tab.page.waitForSelector('[data-part=record][aria-pressed=false]');
    // The button shows what is asked; the scene's page does it a moment later.
    await tab.settled();
    assert.equal(await looked(tab), undefined);
    const time = await tab.scene.evaluate(
      () => (window as any).worldOf(document.querySelector('x3d')).time,
    );
    assert.ok(Math.abs(time - held) < 1e-9, `${time} is ${held}`);
  },

  'where it departs is told, with the step': async (browser, address) => {
    const { kept } = await long(browser, address);
    const { hashes } = kept.runs[0];
    hashes[2]!.hash = '00000000';
    const tab = await Tab.open(browser, address);
    await chosen(tab, JSON.stringify(kept));
    assert.match(
      (await tab.waitForTold(1))[0]!,
      /^Warning: at step 180, .* not where it was then$/,
    );
    assert.equal((await looked(tab))!.hashes.length, 3);
    await tab.choose('Falling box');
    await tab.page.waitForSelector('.told:empty', { state: 'attached' });
  },

  'a file that can’t be read is told in one message, and the scene stays as it was': async (
    browser,
    address,
  ) => {
    const { kept } = await long(browser, address);
    const text = JSON.stringify(kept);
    const files = {
      'may have been cut short': text.slice(0, text.length / 2),
      'This is no run': JSON.stringify({ markup: BOXES }),
      'too large: the playground takes up to 4 MB': text + ' '.repeat(LIMIT),
    };
    const tab = await Tab.open(browser, address, HELD);
    await tab.started();
    await tab.scene.evaluate(() => ((window as any).before = document.querySelector('x3d')));
    for (const [message, file] of Object.entries(files)) {
      await chosen(tab, file);
      await tab.page.locator('.told').getByText(message).waitFor();
      assert.match(await refused(tab), /^Error: /);
      assert.equal(await tab.text(), HELD);
      assert.ok(
        await tab.scene.evaluate(() => (window as any).before === document.querySelector('x3d')),
      );
    }
  },

  'a run of another version or scene is told in one message, and the scene runs without it': async (
    browser,
    address,
  ) => {
    const { kept } = await long(browser, address);
    const [run] = kept.runs;
    const runs = {
      'is of another version': [{ ...run, x3dPhysicsRun: 99 }],
      'parts of this run are missing': [{ ...run, steps: undefined }],
      'is of another scene': kept.runs,
      'that has other worlds': [run, run],
    };
    const tab = await Tab.open(browser, address);
    for (const [message, given] of Object.entries(runs)) {
      await chosen(tab, JSON.stringify({ markup: HELD, runs: given }));
      await tab.page.locator('.told').getByText(message).waitFor();
      assert.match(await refused(tab), /^Error: /);
      assert.equal((await tab.counts()).bodies, 2);
    }
    assert.deepEqual(tab.errors, []);
  },

  'of an address that was cut short the scene is shown, with one message': async (
    browser,
    address,
  ) => {
    const tab = await recorded(browser, address, HELD);
    await drag(tab);
    await tab.press('Share');
    await tab.page.waitForURL(/&run=/);
    const cut = tab.page.url().slice(address.length, -100);
    const other = new Tab(await browser.newPage(), address);
    await other.goTo(cut);
    assert.match(await refused(other), /^Error: .*cut short/);
    assert.equal(await other.text(), HELD);
  },

  'values that one types are recorded, and nodes that one types end it': async (
    browser,
    address,
  ) => {
    const tab = await recorded(browser, address, BOXES);
    await tab.replace('mass="2"', 'mass="3"');
    await step(tab, 60, 'a');
    assert.ok((await run(tab)).calls.some(({ method }) => method === 'set'));
    await tab.replace('<!-- a word -->', '<group></group>');
    await tab.page.getByText('No longer recorded').waitFor();
    assert.equal(await looked(tab), undefined);
    await tab.press('Share');
    await tab.page.waitForURL(/#shared=/);
    assert.doesNotMatch(tab.page.url(), /&run=/);
  },
};
