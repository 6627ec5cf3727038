import assert from 'node:assert/strict';
import type { World } from '../../../../physics-core/inside.js';
import { addBody, addFloor, box, claim, fact, position, world, WEIGHTLESS } from '../../helpers.js';

const unchanged = (w: World): unknown[] =>
  w.problems.filter(({ code }) => code === 'unchanged-value').map(({ attribute }) => attribute);

fact(
  'an equal value that the simulation has left behind is told once, with what acts instead',
  async () => {
    const w = await world();
    claim(w, 'unchanged-value');
    let heard = 0;
    w.on('problem', () => heard++);
    const spun = { position: [0, 5, 0], angularVelocity: [0, 0, 2], linearVelocity: [0, 0, 0] };
    const ball = w.add('RigidBody', { ...spun, orientation: [0, 0, 1, 0] }, { name: 'ball' });
    for (const [field, value] of Object.entries(spun)) ball.set(field, value);
    w.step(0);
    for (const [field, value] of Object.entries(spun)) ball.set(field, value);
    ball.set('orientation', [0, 1, 0, 0]);
    ball.set('orientation', [0, 0, 1, 0]);
    assert.equal(heard, 0, 'before it has moved');
    w.advance(0.5);
    const at = position(ball);
    for (let i = 0; i < 1000; i++) {
      ball.set('position', [0, 5, 0]);
      ball.set('orientation', [0, 0, 1, 0]);
      ball.set('linearVelocity', '0 0 0');
      ball.set('angularVelocity', [0, 0, 2]);
      ball.set('mass', 1);
    }
    assert.deepEqual(position(ball), at, 'and nothing is done');
    assert.deepEqual(unchanged(w), ['position', 'orientation', 'linearVelocity']);
    assert.equal(heard, 3);
    const [moves, , kicks] = w.problems;
    assert.equal(moves!.severity, 'info');
    assert.match(
      moves!.message,
      /RigidBody "ball": position="0 5 0" .* it is 0 3.775 0 by now; teleport\(\) moves it/,
    );
    assert.match(kicks!.message, /applyImpulse\(\) kicks it/);
    ball.set('position', [1, 5, 0]);
    w.step(0);
    assert.deepEqual(unchanged(w), ['orientation', 'linearVelocity'], 'a new value is an edit');
    w.advance(0.5);
    ball.set('position', [1, 5, 0]);
    assert.equal(heard, 3, 'its author knows');
  },
);

fact(
  'nothing is told of what stands where it was put, of velocities of what is fixed, or of edits that wait',
  async () => {
    const w = await world();
    addFloor(w);
    const fixed = addBody(w, { fixed: true, position: [5, 1, 0], linearVelocity: [1, 0, 0] });
    const lying = addBody(w, { position: [0, 0.5, 0], geometry: box(1) });
    const thrown = addBody(w, { position: [9, 9, 0] });
    w.advance(1);
    fixed.set('position', [5, 1, 0]);
    fixed.set('linearVelocity', [1, 0, 0]);
    lying.set('position', [0, 0.5, 0]);
    thrown.set('position', [9, 8, 0]);
    thrown.set('position', [9, 8, 0]);
    w.step(0);
    assert.deepEqual(w.problems, []);
  },
);

fact(
  'after a teleport the field still means what was last set: that is no edit, anything else is one',
  async () => {
    const w = await world(WEIGHTLESS);
    claim(w, 'unchanged-value');
    const ball = addBody(w, { position: [0, 5, 0] });
    w.step();
    ball.teleport([9, 0, 0]);
    ball.set('position', [0, 5, 0]);
    assert.deepEqual(position(ball), [9, 0, 0]);
    assert.deepEqual(unchanged(w), ['position']);
    ball.set('position', [1, 1, 1]);
    w.step(0);
    assert.deepEqual(position(ball), [1, 1, 1]);
    w.reset();
    assert.deepEqual(position(ball), [1, 1, 1], 'what was asked last');
  },
);
