// A file of its own: code that has come stays for the whole process.
import assert from 'node:assert/strict';
import { describe } from 'node:test';
import {
  contacts,
  joints,
  loadBullet,
  meshes,
  World,
  type PhysicsNode,
} from '../../../physics-core/inside.js';
import type { CollisionSensorNode } from '../../../physics-core/nodes/collision/collision-sensor-node.js';
import { fact } from '../helpers.js';

const codes = ({ problems }: World): string[] => problems.map(({ code }) => code);

describe('a node made before the code of its class is here', () => {
  fact('becomes one of that class, with its name, fields, listeners and problems', async () => {
    const world = new World();
    const body1 = world.add('RigidBody', {
      position: [1, 5, 0],
      geometry: [{ type: 'Sphere', radius: 0.5 }],
    });
    const hinge = world.add(
      'SingleAxisHingeJoint',
      { body1, anchorPoint: [0, 5, 0], axis: [0, 0, 1], minAngle: -0.5, maxAngle: 0.5 },
      { name: 'hinge' },
    );
    const heard: unknown[] = [];
    hinge.on('jointlimit', (detail: unknown) => heard.push(detail));
    hinge.set('stopErrorCorrection', 7);
    assert.equal(joints.here, false);
    assert.deepEqual([hinge.get('angle'), hinge.get('maxAngle')], [0, 0.5]);
    world.start(await loadBullet());
    await world.ready;
    assert.equal(world.node('hinge'), hinge);
    assert.deepEqual([world.stats.joints, codes(world)], [1, ['out-of-range']]);
    world.advance(2);
    assert.ok(heard.length > 0);
    assert.ok(Math.abs(Math.abs(hinge.get('angle') as number) - 0.5) < 0.01);
    hinge.remove();
    assert.deepEqual([world.stats.joints, world.node('hinge')], [0, undefined]);
    world.destroy();
  });

  fact('may come into a running world, and may be gone before its code comes', async () => {
    const world = new World();
    const ball = world.add('RigidBody', {
      position: [0, 1.05, 0],
      geometry: [{ type: 'Sphere', radius: 1 }],
    });
    world.start(await loadBullet());
    assert.equal(contacts.here, false);
    const collider = world.add('CollisionCollection', { collidables: '*' });
    const sensor = world.add('CollisionSensor', { collider }) as CollisionSensorNode;
    const gone = world.add('CollisionSensor', { collider });
    world.add('RigidBody', { fixed: true, geometry: [{ type: 'Box', size: [9, 0.1, 9] }] });
    gone.remove();
    assert.deepEqual([world.step(), sensor.get('isActive')], [0, false]);
    await contacts.load();
    await new Promise((resolve) => setTimeout(resolve));
    assert.ok(world.step(10) > 0);
    assert.deepEqual([sensor.get('isActive'), gone.removed], [true, true]);
    assert.equal(sensor.contacts.length > 0, true);
    assert.deepEqual(codes(world), []);
    ball.remove();
    world.step();
    assert.equal(sensor.get('isActive'), false);
    world.destroy();
  });

  fact('holds the step in which a listener adds it, and is told of once', async () => {
    const world = new World();
    world.add('RigidBody', { geometry: [{ type: 'Sphere', radius: 1 }] });
    world.start(await loadBullet());
    const told: string[] = [];
    const added: PhysicsNode[] = [];
    const shape = { type: 'Cone', bottomRadius: 1, height: 1, side: false, bottom: true };
    world.on('beforestep', () => {
      told.push('before');
      if (told.length === 1)
        added.push(world.add('RigidBody', { position: [9, 0, 0], geometry: [shape] }));
    });
    world.on('afterstep', () => told.push('after'));
    assert.equal(meshes.here, false);
    assert.deepEqual([world.step(3), world.time, told], [0, 0, ['before']]);
    await meshes.load();
    await new Promise((resolve) => setTimeout(resolve));
    assert.equal(world.step(), world.timeStep);
    assert.deepEqual(told, ['before', 'after']);
    const [, speed] = added[0]!.get('linearVelocity') as number[];
    assert.ok(Math.abs(speed! + 9.8 * world.timeStep) < 1e-6);
    world.destroy();
  });
});
