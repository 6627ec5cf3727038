import assert from 'node:assert/strict';
import { addBody, close, fact, height, position, way, world } from '../../helpers.js';
import { recorded, busy } from '../runs.js';

fact('step and advance return the seconds they advanced, paused or not', async () => {
  const w = await world();
  w.paused = true;
  assert.equal(w.step(), 1 / 120);
  assert.equal(w.step(3), 3 / 120);
  assert.equal(w.advance(0.5), 0.5);
  assert.equal(w.advance(-1), 0);
  close(w.time, 64 / 120, 1e-12, 's');
});

fact('step(0) applies pending edits and advances nothing', async () => {
  const w = await world();
  const ball = addBody(w);
  assert.equal(w.stats.bodies, 0);
  assert.equal(w.step(0), 0);
  assert.equal(w.stats.bodies, 1);
  assert.equal(w.time, 0);
  close(height(ball), 0, 0, 'm');
});

fact('advance takes steps of the level that an edit just asked for', async () => {
  const w = await world();
  w.set('accuracy', 'game');
  assert.equal(w.advance(1), 1);
  w.set('accuracy', 'fine');
  assert.equal(w.advance(1), 1);
  close(w.time, 2, 1e-9, 's');
});

fact('beforestep and afterstep come once per step, around it', async () => {
  const w = await world();
  const ball = addBody(w, { linearVelocity: [1, 0, 0] });
  const log: string[] = [];
  for (const event of ['beforestep', 'afterstep'])
    w.on(event, () => log.push(`${event} ${Math.round(position(ball)[0] * 120)}`));
  w.step(2);
  assert.deepEqual(log, ['beforestep 0', 'afterstep 1', 'beforestep 1', 'afterstep 2']);
});

fact('edits, forces and teleports made in beforestep act in that very step', async () => {
  const w = await world({ gravity: [0, 0, 0] });
  const [pushed, moved, fast] = [
    addBody(w),
    addBody(w, { position: [5, 0, 0] }),
    addBody(w, { position: [9, 0, 0] }),
  ];
  w.step(0);
  const stop = w.on('beforestep', () => {
    pushed.applyForce([120, 0, 0]);
    moved.teleport([5, 3, 0]);
    fast.set('linearVelocity', [0, 0, 12]);
  });
  w.step();
  stop();
  close(position(pushed), [1 / 120, 0, 0], 1e-6, 'm');
  close(position(moved), [5, 3, 0], 1e-6, 'm');
  close(position(fast), [9, 0, 0.1], 1e-5, 'm');
});

fact('edits made in afterstep act in the next step', async () => {
  const w = await world({ gravity: [0, 0, 0] });
  const ball = addBody(w);
  w.step(0);
  const stop = w.on('afterstep', () => ball.set('linearVelocity', [12, 0, 0]));
  w.step();
  stop();
  close(position(ball), [0, 0, 0], 0, 'm');
  w.step();
  close(position(ball), [0.1, 0, 0], 1e-6, 'm');
});

fact('a listener that throws stops neither the step nor the others', async () => {
  const w = await world();
  const ball = addBody(w);
  let heard = 0;
  // The error goes to the page by a microtask, where it counts as uncaught.
  const later: (() => void)[] = [];
  const { queueMicrotask } = globalThis;
  globalThis.queueMicrotask = (task) => later.push(task);
  w.on('beforestep', () => {
    throw new Error('mine');
  });
  w.on('beforestep', () => heard++);
  w.step(1);
  globalThis.queueMicrotask = queueMicrotask;
  assert.equal(heard, 1);
  close(height(ball), -way(9.8, 1 / 120), 1e-6, 'm');
  assert.equal(later.length, 1);
  assert.throws(later[0]!, /mine/);
});

fact('two worlds step side by side as each does alone', async () => {
  const alone = await world();
  busy(alone);
  const log = recorded(alone);
  alone.step(120);
  const [a, b] = [await world(), await world({ gravity: [0, 0, -20] })];
  busy(a);
  busy(b);
  b.add('CollisionCollection', { collidables: '*', bounce: 1 });
  const both = recorded(a);
  for (let i = 0; i < 120; i++) {
    a.step();
    b.step();
  }
  assert.deepEqual(both, log);
});

fact('time is counted in steps, so that it does not round', async () => {
  const w = await world();
  w.step(1200);
  assert.equal(w.time, 10);
  w.accuracy = 'fine';
  w.step(240);
  assert.equal(w.time, 11);
});

fact(
  'a step asked for within a step does nothing, and odd counts are whole steps or none',
  async () => {
    const w = await world();
    addBody(w);
    const inner: number[] = [];
    const stop = w.on('beforestep', () => inner.push(w.step(1)));
    assert.equal(w.step(2), 2 / 120);
    stop();
    assert.deepEqual(inner, [0, 0]);
    close(w.step(1.9), 1 / 120, 1e-12, 's');
    for (const none of [-1, NaN, 0]) assert.equal(w.step(none), 0);
    assert.equal(w.advance(NaN), 0);
    close(w.time, 3 / 120, 1e-12, 's');
  },
);
