import assert from 'node:assert/strict';
import {
  addBody,
  addFloor,
  addJoint,
  box,
  close,
  counts,
  fact,
  height,
  sphere,
  velocity,
  way,
  world,
} from '../helpers.js';

fact('what a node made of plain data goes with it', async () => {
  const w = await world();
  const before = [...w.nodes].length;
  const body = addBody(w, {
    geometry: [
      { type: 'CollidableOffset', collidable: { type: 'CollidableShape', shape: [box(1)] } },
    ],
  });
  w.step();
  assert.equal([...w.nodes].length, before + 3);
  body.set('geometry', [sphere(1)]);
  w.step();
  assert.equal([...w.nodes].length, before + 2);
  body.remove();
  assert.equal([...w.nodes].length, before);
  body.remove();
  assert.equal([...w.nodes].length, before);
});

fact(
  'a body that goes leaves its joint waiting, which holds the next body it is given (S29)',
  async () => {
    const w = await world();
    const [a, b] = [addBody(w), addBody(w, { position: [1, 0, 0] })];
    const joint = addJoint(w, 'BallJoint', { body1: a, body2: b });
    w.step();
    assert.equal(w.stats.joints, 1);
    a.remove();
    w.step();
    assert.equal(w.stats.joints, 0);
    const c = addBody(w, { position: [0, 0, 0], fixed: true });
    joint.set('body1', c);
    w.step(0);
    const gap = joint.gap;
    w.advance(1);
    assert.equal(w.stats.joints, 1);
    close(joint.gap, gap, 5e-3, 'm');
    joint.remove();
    b.event('linearVelocity', [0, 0, 0]);
    const at = height(b);
    w.advance(0.5);
    close(height(b), at - way(9.8, 0.5), 2e-3, 'm, let go');
  },
);

fact('a body on top of one that goes falls at once (S29)', async () => {
  const w = await world();
  const slab = addFloor(w);
  const stone = addBody(w, { position: [0, 0.5, 0], geometry: [box(1)] });
  w.advance(1);
  slab.remove();
  w.advance(0.5);
  close(height(stone), 0.5 - way(9.8, 0.5), 2e-3, 'm');
});

fact('a shape that grows in contact throws nothing out of its place (S30)', async () => {
  const w = await world();
  addFloor(w);
  const stone = addBody(w, { position: [0, 0.5, 0], geometry: [box(1)] });
  const top = addBody(w, { position: [0, 1.5, 0], geometry: [box(1)] });
  w.advance(1);
  stone.set('geometry', [box(1.2)]);
  let fastest = 0;
  for (let i = 0; i < 240; i++) {
    w.step();
    fastest = Math.max(fastest, ...[stone, top].map((body) => Math.hypot(...velocity(body))));
  }
  assert.ok(fastest < 1, `${fastest} m/s`);
  close([height(stone), height(top)], [0.6, 1.7], 5e-3, 'm');
});

fact('counts of made and unmade objects follow the nodes', async () => {
  const w = await world();
  const before = counts(w);
  const ball = addBody(w, { geometry: [] });
  const joint = addJoint(w, 'BallJoint', { body1: ball });
  assert.equal(counts(w).created, before.created + 2);
  joint.remove();
  ball.remove();
  assert.equal(counts(w).destroyed, before.destroyed + 2);
});
