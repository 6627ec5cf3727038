// What holds of every example, whatever it is written in: what its state says is what its world has. Each fact starts
// from a page of its own.
/* global document */
import assert from 'node:assert/strict';

// ---- in the page ----------------------------------------------------------------------------------------------------

/** What the world of the page's bodies has, by id. */
async function seen(seconds) {
  const bodies = [...document.querySelectorAll('x3d-rigid-body')];
  const world = await bodies[0].world.ready;
  if (seconds) world.advance(seconds);
  const { bodies: count, joints, created, patched, destroyed } = world.stats;
  return {
    count,
    joints,
    edits: created + patched + destroyed,
    order: bodies.map(({ id }) => id),
    poses: Object.fromEntries(bodies.map((body) => [body.id, body.readPose([])])),
    masses: Object.fromEntries(bodies.map((body) => [body.id, world.node(body).get('mass')])),
    // A machine that is busy with other things drops time.
    problems: world.problems.filter(({ code }) => code !== 'lag').map(({ message }) => message),
    canvases: document.querySelectorAll('canvas.x3dom-canvas').length,
    ended: globalThis.ended ?? 0,
  };
}

/** Counts the contacts that end from now on. */
function countEnds() {
  globalThis.ended = 0;
  document.addEventListener('collisionend', () => globalThis.ended++);
}

export const look = (page, seconds = 0) => page.evaluate(seen, seconds);
const heightOf = ({ poses }, id) => poses[id][1];

// ---- what people do -------------------------------------------------------------------------------------------------

const press = (page, name) => page.getByRole('button', { name, exact: true }).click();
const tick = (page, name, on) => page.getByRole('checkbox', { name }).setChecked(on);
const rows = (page) => page.getByRole('listitem');

/** Milliseconds after which what is waited for won't come: the next example is built meanwhile. */
const PATIENCE = 30_000;

/** Until what is seen is as it should be: frameworks render when they like. */
export async function until(page, holds, what) {
  for (const end = Date.now() + PATIENCE; Date.now() < end; await page.waitForTimeout(50)) {
    const now = await look(page);
    if (holds(now)) return now;
  }
  assert.fail(`${what}: ${JSON.stringify(await look(page))}`);
}

/** Nothing moves any more: without the lamp all blocks come to rest. */
async function atRest(page) {
  await tick(page, 'Lamp', false);
  await until(page, ({ joints }) => joints === 0, 'the joint is gone');
  await page.evaluate(countEnds);
  return look(page, 8);
}

// ---- facts ----------------------------------------------------------------------------------------------------------

async function falls(page) {
  const before = await look(page);
  assert.deepEqual([before.count, before.joints], [5, 1]);
  const after = await look(page, 5);
  for (const id of ['block-1', 'block-2', 'block-3'])
    assert.ok(Math.abs(heightOf(after, id) - 0.5) < 0.01, `${id} lies on the floor`);
}

async function counts(page) {
  await look(page, 5);
  await rows(page).filter({ hasText: '1 hits' }).nth(2).waitFor();
  assert.equal(await rows(page).count(), 3);
}

async function rendersAgain(page) {
  const before = await atRest(page);
  await press(page, 'Render 1000 times');
  await page.getByRole('status').filter({ hasText: '1000' }).waitFor();
  const after = await look(page, 1);
  assert.deepEqual(after, before);
}

async function adds(page) {
  await look(page, 5);
  await press(page, 'Add');
  await until(page, ({ count }) => count === 6, 'a sixth body');
  const after = await look(page, 5);
  assert.ok(Math.abs(heightOf(after, 'block-4') - 0.5) < 0.01, 'it lies on the floor, too');
  assert.equal(await rows(page).count(), 4);
}

async function removes(page) {
  const before = await atRest(page);
  await press(page, 'Remove block 2');
  const after = await until(page, ({ count }) => count === before.count - 1, 'a body less');
  assert.equal(after.poses['block-2'], undefined);
  assert.deepEqual(after.poses['block-3'], before.poses['block-3']);
}

async function reorders(page) {
  const before = await atRest(page);
  await press(page, 'Reverse');
  const order = ['block-3', 'block-2', 'block-1'];
  const blocks = (now) => now.order.filter((id) => id.startsWith('block'));
  const after = await until(page, (now) => `${blocks(now)}` === `${order}`, 'in reverse');
  const later = await look(page, 1);
  assert.deepEqual(after.poses, before.poses);
  assert.deepEqual([later.poses, later.ended], [before.poses, 0]);
}

async function edits(page) {
  const before = await atRest(page);
  await rows(page).first().getByRole('spinbutton').fill('7');
  const after = await until(page, ({ masses }) => masses['block-1'] === 7, 'the mass is 7');
  assert.equal(after.masses['block-2'], 1);
  // It is awake again, and lies where it lay.
  const moved = after.poses['block-1'].map((each, i) =>
    Math.abs(each - before.poses['block-1'][i]),
  );
  assert.ok(Math.max(...moved) < 1e-4, `it moved by ${moved}`);
  assert.deepEqual(after.poses['block-2'], before.poses['block-2']);
}

async function joins(page) {
  await tick(page, 'Lamp', false);
  await until(page, ({ joints, count }) => joints === 0 && count === 4, 'no lamp');
  await tick(page, 'Lamp', true);
  await until(page, ({ joints, count }) => joints === 1 && count === 5, 'the lamp again');
  const { poses } = await look(page, 2);
  const [x, y, z] = poses.lamp;
  assert.ok(Math.abs(Math.hypot(x, y - 7, z + 2) - 3) < 0.001, 'it hangs on its joint');
}

const SIX = 6;

async function comesAndGoes(page) {
  const before = await look(page);
  const first = await page.evaluateHandle(() => document.querySelector('x3d-rigid-body').world);
  for (let i = 0; i < SIX; i++) {
    await tick(page, 'Scene', false);
    await page.locator('x3d').waitFor({ state: 'detached' });
    await tick(page, 'Scene', true);
    await page.locator('x3d canvas').waitFor();
  }
  const after = await look(page);
  assert.deepEqual([after.count, after.joints], [before.count, before.joints]);
  assert.deepEqual([after.canvases, after.problems], [1, []]);
  assert.equal(await first.evaluate((world) => world.step(1)), 0, 'the first world has ended');
  assert.ok(Math.abs(heightOf(await look(page, 5), 'block-1') - 0.5) < 0.01);
}

export const FACTS = [
  ['its blocks fall and come to rest on the floor', falls],
  ['a handler that stands in the template hears of each hit', counts],
  ['a thousand renders with the same values move nothing and end no contact', rendersAgain],
  ['a block that is added falls in the running world', adds],
  ['a block that is removed is gone, and the others lie as they lay', removes],
  ['blocks in another order lie as they lay, and stay in touch', reorders],
  ['a mass that is edited is the mass of the body', edits],
  ['a joint comes and goes with what it holds', joins],
  ['a scene that is taken away and put back six times leaves nothing behind', comesAndGoes],
];

/** Another route and back, by the links of the page. */
async function changesRoute(page) {
  const first = await page.evaluateHandle(() => document.querySelector('x3d-rigid-body').world);
  await page.getByRole('link', { name: 'About' }).click();
  await page.locator('x3d').waitFor({ state: 'detached' });
  await page.getByRole('heading', { name: 'About' }).waitFor();
  assert.equal(await first.evaluate((world) => world.step(1)), 0, 'the first world has ended');
  await page.getByRole('link', { name: 'Blocks' }).click();
  await page.locator('x3d canvas').waitFor();
  await falls(page);
}

export const ROUTES = [
  ['a route that is left and come back to has its blocks fall anew', changesRoute],
];

/** After each fact: nothing was said in the console, and the world has no problem. */
export async function quiet(page, messages) {
  assert.deepEqual(messages, []);
  assert.deepEqual((await look(page)).problems, []);
}
