import assert from 'node:assert/strict';
import {
  addBody,
  addFloor,
  box,
  claim,
  close,
  fact,
  height,
  position,
  sphere,
  velocity,
  way,
  world,
  type Node,
  type Sensor,
} from '../../helpers.js';

const SIZE = 2;

/** A block without a body, top at `top`, in a collection. */
async function scene(fields: object = {}, top = 0) {
  const w = await world();
  const block = w.add('CollidableShape', {
    shape: [box(SIZE)],
    translation: [0, top - SIZE / 2, 0],
    ...fields,
  });
  const collection = w.add('CollisionCollection', { collidables: [block] });
  return { w, block, collection };
}

fact('a collidable without a body carries what falls on it, where it is listed', async () => {
  const { w, block } = await scene();
  const ball = addBody(w, { position: [0, 2, 0] });
  const stray = addBody(w, { position: [5, 2, 0] });
  w.add('CollidableShape', { shape: [box(SIZE)], translation: [5, -1, 0] });
  w.advance(2);
  close(height(ball), 0.5, 1e-3, 'm, on the listed one');
  close(height(stray), 2 - way(9.8, 2), 5e-3, 'm, through the one in no collection');
  assert.equal(w.stats.bodies, 2);
  assert.equal(w.node(block.id), block);
  assert.equal([...w.nodes].filter((node) => node.type.name === 'RigidBody').length, 2);
});

fact('an obstacle in a disabled collection only is an obstacle all the same', async () => {
  const { w, collection } = await scene();
  collection.set('enabled', false);
  const ball = addBody(w, { position: [0, 2, 0] });
  w.advance(2);
  close(height(ball), 0.5, 1e-3, 'm');
});

fact('an obstacle of `*` is every collidable that no body owns', async () => {
  const { w, block, collection } = await scene();
  collection.set('collidables', '*');
  const ball = addBody(w, { position: [0, 2, 0] });
  w.advance(2);
  close(height(ball), 0.5, 1e-3, 'm');
  assert.equal(ball.parts[0]!.collidable.obstacle, undefined);
  assert.ok((block as never as { obstacle: unknown }).obstacle);
});

fact(
  'an obstacle follows edits: a leap is a jump, small moves carry what stands on it',
  async () => {
    const { w, block } = await scene();
    w.add('CollisionCollection', { collidables: '*', frictionCoefficients: [1, 1] });
    const stone = addBody(w, { position: [0, 0.5, 0], geometry: [box(1)] });
    w.advance(0.5);
    // 0.5 m/s for a second, a move per frame.
    for (let i = 1; i <= 60; i++) {
      block.event('translation', [(0.5 * i) / 60, -1, 0]);
      w.advance(1 / 60);
    }
    close(position(stone), [0.5, 0.5, 0], 0.03, 'm, carried along');
    block.event('translation', [9, -1, 0]);
    w.advance(0.5);
    close(height(stone), 0.5 - way(9.8, 0.5), 0.02, 'm, nothing below it any more');
  },
);

fact('an obstacle pushes what is in its way', async () => {
  const { w, block } = await scene({ shape: [box(1)], translation: [-2, 0.5, 0] });
  addFloor(w);
  const ball = addBody(w, { position: [0, 0.5, 0] });
  w.advance(0.5);
  for (let i = 1; i <= 60; i++) {
    block.event('translation', [-2 + (2 * i) / 60, 0.5, 0]);
    w.advance(1 / 60);
  }
  assert.ok(position(ball)[0] > 1 - 1e-3, `pushed to ${position(ball)[0]} m`);
});

fact('an obstacle turns: its rotation is that of its shape', async () => {
  const { w, block } = await scene({ shape: [box(0.5, 4, 0.5)], translation: [0, 0, 0] });
  const ball = addBody(w, { position: [0, 3, 0], linearVelocity: [0, 0, 0] });
  w.advance(1);
  close(height(ball), 2.5, 5e-3, 'm, on end');
  block.set('rotation', [0, 0, 1, Math.PI / 2]);
  ball.event('position', [1.5, 2, 0]);
  ball.event('linearVelocity', [0, 0, 0]);
  w.advance(1);
  close(height(ball), 0.75, 5e-3, 'm, lying');
});

fact('an obstacle disappears while disabled, with another shape it has that', async () => {
  const { w, block } = await scene();
  const ball = addBody(w, { position: [0, 0.5, 0] });
  block.set('enabled', false);
  w.advance(0.5);
  close(height(ball), 0.5 - way(9.8, 0.5), 5e-3, 'm');
  block.set('enabled', true);
  block.set('shape', [sphere(3)]);
  ball.event('position', [0, 4, 0]);
  ball.event('linearVelocity', [0, 0, 0]);
  w.advance(1);
  close(height(ball), 2.5, 5e-3, 'm');
});

fact('an obstacle of offsets stands where all of them say', async () => {
  const w = await world();
  const inner = w.add('CollidableOffset', {
    translation: [0, 1, 0],
    collidable: { type: 'CollidableShape', shape: [box(1)], translation: [0, 0, 3] },
  });
  const outer = w.add('CollidableOffset', { translation: [4, 0, 0], collidable: inner });
  w.add('CollisionCollection', { collidables: [outer] });
  const ball = addBody(w, { position: [4, 4, 3] });
  w.advance(2);
  close(height(ball), 2, 1e-3, 'm');
  outer.set('translation', [4, 2, 0]);
  ball.event('position', [4, 6, 3]);
  w.advance(2);
  close(height(ball), 4, 1e-3, 'm, moved up by two');
});

fact('a body that claims an obstacle takes it over, and leaves it as one', async () => {
  const { w, block } = await scene();
  const ball = addBody(w, { position: [0, 2, 0] });
  w.advance(1);
  close(height(ball), 0.5, 1e-3, 'm');
  const lift = addBody(w, { fixed: true, position: [0, 1, 0], geometry: [block] });
  ball.event('position', [0, 4, 0]);
  w.advance(2);
  close(height(ball), 2.5, 1e-3, 'm, on the body that claimed it');
  lift.remove();
  ball.event('position', [0, 2, 0]);
  w.advance(2);
  close(height(ball), 0.5, 1e-3, 'm, an obstacle again');
});

fact('an obstacle goes with its listing and with its node', async () => {
  const { w, block, collection } = await scene();
  const ball = addBody(w, { position: [0, 0.5, 0] });
  w.advance(0.5);
  collection.set('collidables', []);
  w.advance(0.5);
  close(height(ball), 0.5 - way(9.8, 0.5), 2e-3, 'm, listed nowhere');
  collection.set('collidables', [block]);
  ball.event('position', [0, 0.5, 0]);
  ball.event('linearVelocity', [0, 0, 0]);
  w.advance(0.5);
  close(height(ball), 0.5, 1e-3, 'm, listed again');
  block.remove();
  w.advance(0.5);
  close(height(ball), 0.5 - way(9.8, 0.5), 2e-3, 'm, removed');
});

fact('an obstacle is sensed by a sensor, with the body that touches it', async () => {
  const { w, block, collection } = await scene();
  const shape = w.add('CollidableShape', { shape: [sphere(0.5)] });
  collection.set('collidables', [block, shape]);
  const sensor = w.add('CollisionSensor', { collider: collection }) as Sensor;
  addBody(w, { position: [0, 1, 0], geometry: [shape] });
  w.step();
  assert.equal(sensor.get('isActive'), false);
  w.advance(1);
  assert.equal(sensor.get('isActive'), true);
  assert.deepEqual(new Set(sensor.get('intersections') as Node[]), new Set([block, shape]));
});

fact('an obstacle obeys a collider: who is not in it with the obstacle falls through', async () => {
  const { w, block, collection } = await scene();
  const inside = w.add('CollidableShape', { shape: [sphere(0.5)] });
  collection.set('collidables', [block, inside]);
  w.set('collider', collection);
  const held = addBody(w, { position: [0, 0.5, 0], geometry: [inside] });
  const other = addBody(w, { position: [0.5, 0.5, 0.5] });
  claim(w, 'not-in-collider');
  w.advance(0.5);
  close(height(held), 0.5, 1e-3, 'm, inside');
  close(height(other), 0.5 - way(9.8, 0.5), 2e-3, 'm, left out');
});

fact('a reset puts an obstacle back, and the first steps are the same bit for bit', async () => {
  const { w, block } = await scene();
  const ball = addBody(w, { position: [0.1, 1.5, 0], geometry: [box(0.7)] });
  const run = () => {
    for (let i = 1; i <= 30; i++) {
      block.event('translation', [i / 100, -1, 0]);
      w.step(2);
    }
    return [...position(ball), ...velocity(ball)];
  };
  const first = run();
  w.reset();
  assert.deepEqual(block.get('translation'), [0, -1, 0]);
  assert.deepEqual(run(), first);
});

fact('obstacles alone call for no effect', async () => {
  const w = await world({ rest: 'auto' });
  w.add('CollidableShape', { shape: [box(1)] });
  w.add('CollisionCollection', { collidables: '*' });
  w.step();
  assert.ok(w.effects.every(({ active }) => !active));
});
