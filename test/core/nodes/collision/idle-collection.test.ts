import assert from 'node:assert/strict';
import { addBody, claim, fact, world } from '../../helpers.js';

fact(
  'a collection that says what contacts are like, and lists nobody, says so until it does',
  async () => {
    const w = await world();
    const ball = addBody(w);
    const told = () => w.problems.filter(({ code }) => code === 'idle-collection').length;
    const collection = w.add('CollisionCollection', { bounce: 0.5 });
    claim(w, 'idle-collection');
    w.step();
    assert.equal(told(), 1);
    collection.set('collidables', '*');
    w.step();
    assert.equal(told(), 0);
    ball.remove();
  },
);

fact('one that lists nobody and says nothing is no mistake', async () => {
  const w = await world();
  w.add('CollisionCollection');
  w.step();
  assert.deepEqual(w.problems, []);
});
