import assert from 'node:assert/strict';
import { createWorld } from '../../physics-core/create.js';
import { close, distance, fact, watch, way } from './helpers.js';

// The example of the core's contract, to the letter.

async function example() {
  const world = await createWorld({ gravity: [0, -9.8, 0], accuracy: 'standard' });
  watch(world);
  const ball = world.add('RigidBody', {
    mass: 2,
    position: [0, 5, 0],
    geometry: [{ type: 'Sphere', radius: 0.5 }],
  });
  const floor = world.add('RigidBody', {
    fixed: true,
    geometry: [{ type: 'Box', size: [20, 1, 20] }],
  });
  const stone = world.add('RigidBody', {
    position: [3, 5, 0],
    geometry: [{ type: 'Box', size: [1, 1, 1] }],
  });
  world.add('BallJoint', { body1: ball, anchorPoint: [0, 8, 0] });
  world.add('CollisionCollection', {
    collidables: '*',
    appliedParameters: ['BOUNCE'],
    bounce: 0.8,
  });
  return { world, ball, floor, stone };
}

fact(
  'the ball hangs still on its joint, and the stone falls, bounces and comes to rest on the floor',
  async () => {
    const { world, ball, stone } = await example();
    assert.equal(world.advance(0.75), 0.75);
    close((stone.get('position') as number[])[1]!, 5 - way(9.8, 0.75), 1e-3, 'm, falling');
    assert.equal(world.advance(0.25), 0.25);
    // 4 m down, and back up with 0.8 of the speed.
    const hit = Math.sqrt((2 * 4) / 9.8);
    const back = 1 + 0.8 * 9.8 * hit * (1 - hit) - 4.9 * (1 - hit) ** 2;
    close((stone.get('position') as number[])[1]!, back, 0.15, 'm, a moment after the bounce');
    close(ball.get('position') as number[], [0, 5, 0], 1e-4, 'm, hanging');
    world.advance(20);
    close((stone.get('position') as number[])[1]!, 1, 5e-3, 'm, at rest');
  },
);

fact('a pushed ball stays at its distance from the anchor', async () => {
  const { world, ball } = await example();
  ball.set('linearVelocity', [2, 0, 0]);
  for (let i = 0; i < 240; i++) {
    world.step();
    close(distance(ball.get('position') as number[], [0, 8, 0]), 3, 0.01, 'm');
  }
});

fact('what was set is read back, a body goes, the world ends', async () => {
  const { world, ball } = await example();
  world.advance(1);
  ball.set('mass', 3);
  assert.equal(ball.get('mass'), 3);
  assert.equal(world.stats.bodies, 3);
  assert.equal(world.stats.joints, 1);
  ball.remove();
  world.advance(1);
  assert.equal(world.stats.bodies, 2);
  assert.equal(world.stats.joints, 0);
});

fact('values are copied both ways', async () => {
  const { world, ball } = await example();
  const place = [1, 2, 3];
  ball.set('position', place);
  place[0] = 99;
  world.step(0);
  const read = ball.get('position') as number[];
  close(read, [1, 2, 3], 1e-6);
  read[0] = 99;
  close(ball.get('position') as number[], [1, 2, 3], 1e-6);
});

fact('X3D text, arrays, nested arrays and typed arrays are the same value', async () => {
  const { world, ball } = await example();
  for (const value of ['1 2 3', '1, 2, 3', [1, 2, 3], new Float32Array([1, 2, 3])]) {
    ball.set('position', [0, 0, 0]);
    ball.set('position', value);
    world.step(0);
    close(ball.get('position') as number[], [1, 2, 3], 1e-6);
  }
  for (const value of [
    '1 0 0, 0 1 0',
    [
      [1, 0, 0],
      [0, 1, 0],
    ],
    new Float64Array([1, 0, 0, 0, 1, 0]),
  ]) {
    ball.set('forces', value);
    assert.deepEqual(ball.get('forces'), [
      [1, 0, 0],
      [0, 1, 0],
    ]);
  }
});
