import assert from 'node:assert/strict';
import { setTimeout as later } from 'node:timers/promises';
import { setFlagsFromString } from 'node:v8';
import { runInNewContext } from 'node:vm';
import { createWorld, loadEngine } from '../../../physics-core/create.js';
import { World } from '../../../physics-core/inside.js';
import {
  addBody,
  box,
  claim,
  close,
  fact,
  height,
  position,
  watch,
  way,
  world,
} from '../helpers.js';
import { recorded, busy } from './runs.js';

fact('before its start a world takes nodes and edits, steps nothing and returns 0', async () => {
  const w = new World();
  const ball = addBody(w, { position: [0, 1, 0] });
  ball.set('position', [0, 7, 0]);
  assert.equal(w.step(), 0);
  assert.equal(w.advance(1), 0);
  assert.equal(w.frame(1 / 60), false);
  assert.equal(w.time, 0);
  assert.equal(w.started, false);
  close(ball.get('position') as number[], [0, 7, 0], 0);
  w.start(await loadEngine());
  watch(w);
  assert.equal(await w.ready, w);
  w.step(60);
  close(height(ball), 7 - way(9.8, 0.5), 1e-4, 'm');
});

fact('ready rejects with the problem of a world that can not start', async () => {
  const w = new World();
  w.lifecycle.ready.reject({ code: 'engine-load-failed' });
  await assert.rejects(w.ready, { code: 'engine-load-failed' });
});

fact('a world tells when it is ready, once', async () => {
  const w = new World();
  let times = 0;
  w.on('ready', () => times++);
  const engine = await loadEngine();
  w.start(engine);
  w.start(engine);
  watch(w);
  assert.equal(times, 1);
});

fact('reset and n steps are the first n steps, bit for bit', async () => {
  const w = await world();
  busy(w);
  w.add('CollisionCollection', { collidables: '*', bounce: 0.3 });
  const log = recorded(w);
  w.step(180);
  const first = log.splice(0);
  w.reset();
  assert.equal(w.time, 0);
  w.step(180);
  assert.deepEqual(log, first);
  w.reset();
  w.reset();
  log.length = 0;
  w.step(60);
  assert.deepEqual(log, first.slice(0, 60));
});

fact('reset goes back to what was asked last, and ends what only the run did', async () => {
  const w = await world({ gravity: [0, 0, 0] });
  const ball = addBody(w, { position: [1, 0, 0], linearVelocity: [1, 0, 0] });
  w.advance(1);
  ball.set('position', [5, 0, 0]);
  ball.applyForce([1000, 0, 0]);
  w.reset();
  close(position(ball), [5, 0, 0], 0, 'm');
  w.advance(1);
  close(position(ball), [6, 0, 0], 1e-4, 'm');
});

fact('reset undoes what events did, and the author may say the same again', async () => {
  const w = await world({ gravity: [0, 0, 0] });
  claim(w, 'unchanged-value');
  const ball = addBody(w, { position: [0, 9, 0], mass: 2 });
  w.step();
  ball.event('position', [7, 7, 7]);
  ball.event('linearDampingFactor', 0.5);
  w.step();
  close(position(ball), [7, 7, 7], 1e-6, 'm');
  const { patched } = w.stats;
  ball.set('position', [0, 9, 0]);
  w.step();
  assert.equal(w.stats.patched, patched);
  w.reset();
  close(position(ball), [0, 9, 0], 1e-6, 'm');
  assert.equal(ball.asked('linearDampingFactor'), 0.001);
});

fact(
  'what the console was told it is not told again after a reset; what is new it is',
  async () => {
    const said: string[] = [];
    const w = await createWorld({ console: ({ code }: { code: string }) => said.push(code) });
    const weightless = addBody(w, { mass: 0 });
    addBody(w, { position: [0.5, 0, 0] });
    w.step();
    const told = [...said];
    assert.ok(told.includes('zero-mass') && told.includes('initial-overlap'));
    w.reset();
    w.step();
    assert.deepEqual(said, told);
    assert.deepEqual(w.problems.map(({ code }) => code).sort(), told.toSorted());
    weightless.set('mass', 1);
    w.step();
    weightless.set('mass', 0);
    w.step();
    assert.deepEqual(said, [...told, 'zero-mass']);
    w.destroy();
  },
);

/** A world that has read contacts, ended; nobody has it any more. */
async function gone(): Promise<WeakRef<World>> {
  const w = await createWorld({ console: false });
  const floor = w.add('CollidableShape', { shape: [box(1)] });
  w.add('CollisionCollection', { collidables: '*', bounce: 0.5 });
  w.on('collisionstart', () => {});
  addBody(w, { position: [0, 0.9, 0] });
  floor.set('translation', [0, -0.5, 0]);
  w.advance(1);
  w.destroy();
  return new WeakRef(w);
}

fact('a world that has ended is let go, by the engine too', async () => {
  const world = await gone();
  setFlagsFromString('--expose-gc');
  const collect = runInNewContext('gc') as () => void;
  for (let times = 0; times < 10 && world.deref(); times++) {
    await later();
    collect();
  }
  assert.ok(!world.deref());
});
