// What holds of the starter: a stranger's first page does what its buttons say.
/* global document */
import assert from 'node:assert/strict';

/** Runs in the page: where bodies are after so many seconds, and what is wrong. */
async function seen(seconds) {
  const bodies = [...document.querySelectorAll('x3d-rigid-body')];
  const world = await bodies[0].world.ready;
  world.advance(seconds);
  const boxes = bodies.filter((body) => body.classList.contains('box'));
  return {
    ball: document.getElementById('ball').position,
    top: Math.max(...boxes.map((body) => body.position[1])),
  };
}

const look = (page, seconds = 0) => page.evaluate(seen, seconds);
const press = (page, name) => page.getByRole('button', { name, exact: true }).click();

async function stands(page) {
  const { top, ball } = await look(page, 3);
  assert.ok(Math.abs(top - 2) < 0.01, `its top lies at ${top} m`);
  assert.ok(Math.abs(ball[1] - 0.4) < 0.01, `the ball lies at ${ball[1]} m`);
}

async function throws(page) {
  await look(page);
  await press(page, 'Throw');
  const { top } = await look(page, 4);
  assert.ok(top < 1.9, `its top still lies at ${top} m`);
  await page
    .getByRole('status')
    .filter({ hasText: /^[1-9]\d* hits$/ })
    .waitFor();
}

async function startsAgain(page) {
  await throws(page);
  await press(page, 'Start again');
  await stands(page);
  await page
    .getByRole('status')
    .filter({ hasText: /^0 hits$/ })
    .waitFor();
}

export const STARTER = [
  ['its pyramid stands, and its ball lies', stands],
  ['the ball that is thrown strikes boxes, and they are counted', throws],
  ['Start again puts all back, the counter too', startsAgain],
];
