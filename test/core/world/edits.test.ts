import assert from 'node:assert/strict';
import { World } from '../../../physics-core/inside.js';
import { addBody, claim, close, counts, fact, position, velocity, world } from '../helpers.js';

fact(
  'a value equal to the one last asked for is no edit, even where the live value has moved on',
  async () => {
    const w = await world();
    claim(w, 'unchanged-value');
    const ball = addBody(w, { position: [0, 5, 0] });
    w.advance(0.5);
    const at = position(ball);
    for (let i = 0; i < 1000; i++) ball.set('position', [0, 5, 0]);
    w.step(0);
    close(position(ball), at, 0, 'm');
    ball.event('position', [0, 5, 0]);
    w.step(0);
    close(position(ball), [0, 5, 0], 0, 'm, an event always acts');
  },
);

fact('several fields edited together are one patch of each setter', async () => {
  const w = await world({ gravity: [0, 0, 0] });
  const ball = addBody(w);
  w.step();
  const before = counts(w);
  ball.set('mass', 4);
  ball.set('linearVelocity', [1, 0, 0]);
  ball.set('linearVelocity', [2, 0, 0]);
  ball.set('forces', [[0, 4, 0]]);
  w.advance(1);
  close(velocity(ball), [2, 1, 0], 1e-4, 'm/s');
  assert.deepEqual(counts(w), { ...before, patched: before.patched + 3 });
});

fact('an edit before the node exists in Bullet counts as part of its creation', async () => {
  const w = await world({ gravity: [0, 0, 0] });
  const ball = addBody(w);
  ball.set('linearVelocity', [1, 0, 0]);
  const { patched } = counts(w);
  assert.equal(patched, 0);
  w.advance(1);
  close(position(ball), [1, 0, 0], 1e-4, 'm');
});

fact('methods act on a body that was only just added', async () => {
  const w = await world({ gravity: [0, 0, 0] });
  const [pushed, moved] = [addBody(w), addBody(w, { position: [9, 0, 0] })];
  pushed.applyImpulse([2, 0, 0]);
  moved.teleport([0, 5, 0]);
  w.advance(1);
  close(position(pushed), [2, 0, 0], 1e-4, 'm');
  close(position(moved), [0, 5, 0], 1e-4, 'm');
});

fact('a body that was just added is where it starts, not where a default would be', async () => {
  const start = { p: [1, 2, 3], q: [0, 0, 0, 1] } as const;
  const w = await world({ gravity: [0, 0, 0] });
  w.step();
  const late = w.add('RigidBody', {}, { start: start as never });
  close(late.get('position') as number[], [1, 2, 3], 1e-6, 'm');
  w.paused = true;
  const early = new World();
  const waiting = early.add('RigidBody', {}, { start: start as never });
  close(waiting.get('position') as number[], [1, 2, 3], 1e-6, 'm, before the start');
  early.destroy();
});
