import assert from 'node:assert/strict';
import {
  addBody,
  addFloor,
  box,
  close,
  fact,
  height,
  position,
  sphere,
  spin,
  way,
  world,
  type Body,
} from '../../helpers.js';

fact('two bodies of one joint do not collide, and do again when the joint goes', async () => {
  const w = await world({ gravity: [0, 0, 0] });
  const a = addBody(w, { position: [0, 0, 0] });
  const b = addBody(w, { position: [0.6, 0, 0] });
  const joint = w.add('BallJoint', { body1: a, body2: b, anchorPoint: [0.3, 0, 0] });
  w.advance(0.5);
  close(position(b)[0] - position(a)[0], 0.6, 1e-4, 'm, held inside each other');
  joint.remove();
  w.advance(1);
  assert.ok(position(b)[0] - position(a)[0] > 0.95, 'apart');
});

fact('a joint between bodies that touch takes their contact away at once', async () => {
  const w = await world();
  addFloor(w);
  const lower = addBody(w, { fixed: true, position: [0, 1, 0], geometry: [box(1)] });
  const upper = addBody(w, { position: [0, 2, 0], geometry: [box(1)] });
  w.advance(1);
  close(height(upper), 2, 1e-3, 'm');
  w.add('SingleAxisHingeJoint', {
    body1: upper,
    body2: lower,
    anchorPoint: [0.5, 2, 0],
    axis: [0, 0, 1],
  });
  upper.applyImpulse([0, 0.1, 0]);
  w.advance(2);
  // It swings through the lower one like a pendulum about its corner.
  assert.ok(Math.abs(spin(upper)[2]) + Math.abs(height(upper) - 2) > 0.3, `${height(upper)} m`);
});

fact('two fixed bodies have no contact, nor has a carried one with a fixed one', async () => {
  const w = await world();
  const still = addBody(w, { fixed: true, geometry: [box(2)] });
  const carried = addBody(w, { fixed: true, position: [1.5, 0, 0], geometry: [box(2)] });
  addBody(w, { position: [0, 50, 0] });
  const sensor = w.add('CollisionSensor', {
    collider: w.add('CollisionCollection', { collidables: '*' }),
  });
  for (let i = 0; i < 10; i++) {
    carried.event('position', [1.5 - i / 100, 0, 0]);
    w.step(2);
    assert.equal(sensor.get('isActive'), false);
  }
  close(position(still), [0, 0, 0], 0, 'm');
});

fact('bodies in a shared world keep the gravity and rest of their own collection', async () => {
  const w = await world({ gravity: [0, -9.8, 0], disableTime: 0.1, disableLinearSpeed: 1 });
  const moon = w.add('RigidBodyCollection', { gravity: [0, -1.6, 0], autoDisable: true });
  for (const [name, value] of Object.entries({ disableTime: 0.5, disableLinearSpeed: 0.1 }))
    moon.set(name, value);
  moon.set('disableAngularSpeed', 0.1);
  const here = addBody(w, { position: [0, 10, 0] });
  const there = w.add(
    'RigidBody',
    { position: [5, 10, 0], geometry: [sphere(0.5)] },
    { collection: moon },
  ) as Body;
  w.advance(1);
  close(height(here), 10 - way(9.8, 1), 1e-3, 'm, on earth');
  close(height(there), 10 - way(1.6, 1), 1e-3, 'm, on the moon');
  moon.set('gravity', [0, 0, 0]);
  there.event('linearVelocity', [0, 0, 0]);
  w.advance(1.2);
  assert.equal(there.sleeping, true, 'by the disable fields of its collection');
  assert.equal(here.sleeping, false);
});
