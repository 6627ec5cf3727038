// The one file in which code comes late in Node: no world is made by `createWorld`, which has it all come first.
import assert from 'node:assert/strict';
import { describe, mock } from 'node:test';
import {
  chunks,
  contacts,
  impacts,
  joints,
  loadBullet,
  World,
} from '../../../physics-core/inside.js';
import { fact } from '../helpers.js';

const JOINT_CODE = () => import('../../../physics-core/world/chunks/joint-code.js');
const NO_NETWORK = () => Promise.reject(new Error('no network'));
/** Longer than the pause before another attempt, milliseconds. */
const LATER = 6000;

const ball = { position: [0, 5, 0], geometry: [{ type: 'Sphere', radius: 0.5 }] };
const codes = ({ problems }: World): string[] => problems.map(({ code }) => code);
const turns = async (): Promise<void> => {
  for (let i = 0; i < 50; i++) await Promise.resolve();
};

describe('code of effects that is not here', () => {
  fact('is no concern of a body alone', async () => {
    const world = new World();
    world.add('RigidBody', { ...ball });
    world.start(await loadBullet());
    assert.ok(world.started);
    assert.ok(chunks.every(({ here }) => !here));
    assert.ok(world.step(10) > 0);
    world.destroy();
  });

  fact('which can’t be had is a problem, and is tried again', async () => {
    const engine = await loadBullet();
    joints.comesFrom(NO_NETWORK);
    const world = new World();
    const body1 = world.add('RigidBody', { ...ball });
    world.add('BallJoint', { body1, anchorPoint: [0, 8, 0] });
    mock.timers.enable({ apis: ['setTimeout'] });
    world.start(engine);
    await assert.rejects(world.ready, { code: 'effect-load-failed', value: 'joints' });
    assert.equal(world.started, false);
    joints.comesFrom(JOINT_CODE);
    mock.timers.tick(LATER);
    mock.timers.reset();
    await new Promise((resolve) => world.on('ready', resolve));
    assert.equal(world.stats.joints, 1);
    assert.deepEqual(codes(world), []);
    world.destroy();
  });

  fact('holds a world that needs it late, and moves nothing meanwhile', async () => {
    const world = new World();
    const first = world.add('RigidBody', { ...ball });
    world.start(await loadBullet());
    world.step(10);
    const before = first.get('position');
    assert.equal(contacts.here, false);
    world.add('RigidBody', { fixed: true, geometry: [{ type: 'Box', size: [20, 1, 20] }] });
    assert.equal(world.step(10), 0);
    assert.deepEqual(first.get('position'), before);
    assert.deepEqual(codes(world), ['waiting-for-effect']);
    world.restore(world.snapshot());
    world.raycast([0, 10, 0], [0, -10, 0]);
    world.reset();
    assert.deepEqual([world.step(10), world.time], [0, 0]);
    await contacts.load();
    await turns();
    assert.ok(world.step(10) > 0);
    assert.deepEqual([codes(world), world.stats.bodies], [[], 2]);
    world.destroy();
  });

  const floor = { fixed: true, geometry: [{ type: 'Box', size: [20, 1, 20] }] };
  /** Through a floor of a metre within a step, if nobody looked. */
  const shot = { ...ball, linearVelocity: [0, -200, 0] };

  fact('of impacts is no concern of what falls on a floor and lies there', async () => {
    const world = new World();
    world.add('RigidBody', floor);
    const first = world.add('RigidBody', { ...ball, position: [0, 2, 0] });
    world.start(await loadBullet());
    world.advance(3);
    assert.ok(Math.abs((first.get('position') as number[])[1]! - 1) < 1e-3);
    assert.equal(impacts.here, false);
    world.destroy();
  });

  fact(
    'of impacts holds a world in which something is fast; it goes on as if the code had been here',
    async () => {
      const engine = await loadBullet();
      const shots = () => {
        const world = new World();
        world.add('RigidBody', floor);
        const body = world.add('RigidBody', shot);
        world.start(engine);
        return { world, body };
      };
      const late = shots();
      assert.equal(late.world.step(10), 0);
      assert.deepEqual(codes(late.world), ['waiting-for-effect']);
      await impacts.load();
      await turns();
      const early = shots();
      for (const { world } of [late, early]) assert.equal(world.step(60), 0.5);
      assert.ok((late.body.get('position') as number[])[1]! > 0.9);
      for (const field of ['position', 'linearVelocity', 'angularVelocity'])
        assert.deepEqual(late.body.get(field), early.body.get(field));
      assert.deepEqual(codes(late.world), []);
      for (const { world } of [late, early]) world.destroy();
    },
  );
});
