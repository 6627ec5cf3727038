// What holds of a scene that a server has written.
/* global document */
import assert from 'node:assert/strict';
import { look, until } from './facts.js';

/** Runs in the page before all of its scripts: keeps the scene as the server wrote it. */
function keep() {
  document.addEventListener('readystatechange', () => {
    globalThis.written ??= document.querySelector('x3d');
  });
}

async function takenOver(page, address) {
  await page.addInitScript(keep);
  await page.goto(`${address}served`);
  await page.locator('x3d canvas').waitFor();
  const html = await (await page.request.get(`${address}served`)).text();
  assert.match(html, /<x3d-rigid-body id="ball" mass="2"/, 'the server writes the scene');
  const { count, joints, canvases } = await look(page);
  assert.deepEqual([count, joints, canvases], [2, 1, 1]);
  await page.getByRole('button', { name: 'Heavier' }).click();
  await until(page, ({ masses }) => masses.ball === 3, 'React edits what the server wrote');
  const same = await page.evaluate(() => globalThis.written === document.querySelector('x3d'));
  assert.ok(same, 'it is the scene that the server wrote');
  const after = await look(page, 1);
  assert.deepEqual([after.count, after.canvases], [2, 1]);
  assert.ok(Math.abs(Math.hypot(after.poses.ball[0], after.poses.ball[1] - 5) - 3) < 0.001);
}

export const SERVED = [
  ['a scene that the server wrote is taken over, and edited where it stands', takenOver],
];
