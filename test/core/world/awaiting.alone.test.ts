// The one file in which code comes late in Node: no world is made by `createWorld`, which has it all come first.
import assert from 'node:assert/strict';
import { describe, mock } from 'node:test';
import { chunks, contacts, joints, loadBullet, World } from '../../../physics-core/inside.js';
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
});
