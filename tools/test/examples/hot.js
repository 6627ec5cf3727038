// What holds of an example in Vite's dev server while its source is edited: the running page takes each edit.
/* global document */
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { look, until } from './facts.js';

const LAMP = 'radius="0.4"';
const LARGER = 'radius="0.6"';

const TIMES = 4;

/** Runs in the page: bytes of the engine's heap. */
const heapBytes = async () => {
  const { world } = document.querySelector('x3d-rigid-body');
  // A world that was just made anew has no heap before it has started.
  await world.ready;
  return world.stats.heapBytes;
};

/** Runs in the page: how large the lamp is drawn, and that this is still the page that was opened. */
const shown = () => [document.querySelector('sphere')?.getAttribute('radius'), globalThis.opened];

/** Milliseconds after which it is saved again: what watches files may miss one that was written twice at a time. */
const AGAIN = 4000;

/** One edit of the file, as an editor saves it; answers when the page shows it. */
async function save(page, file, text, radius) {
  for (const end = Date.now() + 6 * AGAIN; Date.now() < end;) {
    writeFileSync(file, text);
    if (await comes(page, radius)) return;
  }
  assert.fail(`the edit does not arrive: the lamp has ${await page.evaluate(shown)}`);
}

async function comes(page, radius) {
  for (const end = Date.now() + AGAIN; Date.now() < end; await page.waitForTimeout(50)) {
    const [drawn, opened] = await page.evaluate(shown).catch(() => []);
    if (drawn !== radius) continue;
    assert.ok(opened, 'the page was not loaded anew');
    return true;
  }
  return false;
}

/** `file`: of the scene. It is put back, whatever comes. */
const edited = (file) => async (page) => {
  const before = await look(page);
  const source = readFileSync(file, 'utf8');
  assert.ok(source.includes(LAMP));
  const larger = source.replace(LAMP, LARGER);
  await page.evaluate(() => (globalThis.opened = true));
  let heap;
  try {
    for (let i = 0; i < TIMES; i++) {
      await save(page, file, larger, '0.6');
      await save(page, file, source, '0.4');
      await until(page, ({ count, joints }) => count === 5 && joints === 1, 'its bodies, once');
      // What the first round makes is kept for the next ones.
      heap ??= await page.evaluate(heapBytes);
    }
  } finally {
    writeFileSync(file, source);
  }
  const after = await look(page);
  assert.deepEqual([after.count, after.joints, after.canvases], [before.count, before.joints, 1]);
  assert.deepEqual([...after.order].sort(), [...before.order].sort());
  assert.deepEqual(after.problems, []);
  assert.equal(await page.evaluate(heapBytes), heap);
  const fallen = await look(page, 5);
  assert.ok(Math.abs(fallen.poses['block-1'][1] - 0.5) < 0.01, 'its blocks fall on');
};

/** `path`: of the file with the scene, from the example's folder. */
export const hotFacts = (example, ...path) => [
  [
    'edits of its source arrive in the running page and leave nothing behind',
    edited(join('examples', example, ...path)),
  ],
];
