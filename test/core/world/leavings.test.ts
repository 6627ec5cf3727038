import assert from 'node:assert/strict';
import type { World } from '../../../physics-core/inside.js';
import {
  addBody,
  addFloor,
  addJoint,
  below,
  box,
  claim,
  close,
  fact,
  height,
  position,
  sphere,
  spin,
  world,
} from '../helpers.js';

const active = (w: World): string[] =>
  w.effects.filter((effect) => effect.active).map(({ name }) => name);

const still = { gravity: [0, 0, 0] as [number, number, number] };
const undamped = { linearDampingFactor: 0, angularDampingFactor: 0 };

// ---- what goes takes its doings along -------------------------------------------------------------------------------

fact('a world takes its settings from the next collection when the first one goes', async () => {
  const w = await world({ accuracy: 'game' });
  w.add('RigidBodyCollection', { rest: 'never', accuracy: 'game' }).set('accuracy', 'fine');
  const [first] = w.store.collections;
  first!.remove();
  w.step(0);
  close(w.timeStep, 1 / 240, 1e-12, 's');
  assert.equal(w.accuracy, 'fine');
});

fact('bodies of no collection fall as the next one says when the first one goes', async () => {
  const w = await world({ gravity: [0, 0, 1] });
  w.add('RigidBodyCollection', { rest: 'never', gravity: [0, 2, 0] });
  const ball = addBody(w, { geometry: [sphere(0.5)] });
  w.step();
  ball.teleport([0, 0, 0], undefined, { linearVelocity: [0, 0, 0] });
  const [first] = w.store.collections;
  first!.remove();
  w.advance(1);
  close(height(ball), 1, 1e-4, 'm');
});

fact('a collidable that is removed collides no more', async () => {
  const w = await world();
  addFloor(w);
  const shape = w.add('CollidableShape', { shape: [sphere(0.5)] });
  const ball = addBody(w, { position: [0, 0.5, 0], geometry: [shape] });
  w.step(5);
  shape.remove();
  w.advance(1);
  below(height(ball), -4, 'm');
});

fact('who is removed reads no contacts, though it was or is listened to', async () => {
  const w = await world();
  const shape = w.add('CollidableShape', { shape: [box(1)] });
  w.add('CollisionCollection', { collidables: [shape] });
  shape.on('collisionstart', () => {});
  w.step();
  assert.ok(active(w).includes('contact reading'));
  shape.remove();
  shape.on('collisionend', () => {});
  w.step();
  assert.deepEqual(active(w), []);
});

fact('a joint whose body is gone answers with its own anchor and zeros', async () => {
  const w = await world();
  const [one, two] = [addBody(w), addBody(w, { position: [1, 0, 0] })];
  const joint = addJoint(w, 'SingleAxisHingeJoint', {
    body1: one,
    body2: two,
    anchorPoint: [0.5, 0, 0],
  });
  w.step(3);
  two.remove();
  w.step();
  assert.deepEqual(joint.get('body2AnchorPoint'), [0.5, 0, 0]);
  assert.deepEqual([joint.get('angle'), joint.gap], [0, 0]);
});

// ---- what is edited is not remembered -------------------------------------------------------------------------------

fact('a spinning rod that is turned by a teleport keeps its spin', async () => {
  const w = await world(still);
  const rod = addBody(w, { geometry: [box(4, 0.2, 0.2)], angularVelocity: [5, 0, 0], ...undamped });
  w.step(3);
  rod.teleport([0, 0, 0], [0, 0, 1, Math.PI / 2]);
  w.step();
  close(spin(rod), [5, 0, 0], 1e-3, 'rad/s');
});

fact(
  'a double hinge that is unlocked turns by its motor, and one that is locked has none',
  async () => {
    const w = await world(still);
    const wheel = addBody(w, undamped);
    const joint = addJoint(w, 'DoubleAxisHingeJoint', {
      body1: wheel,
      axis1: [0, 1, 0],
      axis2: [1, 0, 0],
      minAngle1: 0,
      maxAngle1: 0,
      maxTorque1: 1,
      desiredAngularVelocity1: 2,
    });
    w.advance(0.1);
    assert.ok(!active(w).includes('motors'));
    joint.set('minAngle1', 1);
    w.advance(1);
    close(spin(wheel), [0, 2, 0], 1e-3, 'rad/s');
  },
);

fact('a suspension without bodies switches nothing on', async () => {
  const w = await world();
  claim(w, 'no-body');
  const joint = w.add('DoubleAxisHingeJoint', { suspensionForce: 1 });
  w.step(0);
  joint.set('body1', addBody(w));
  w.step(0);
  assert.ok(active(w).includes('suspension'));
  joint.set('body1', null);
  joint.set('suspensionForce', 2);
  w.step(0);
  assert.ok(!active(w).includes('suspension'));
  joint.remove();
});

fact('Euler angles about one and the same axis are none', async () => {
  const w = await world(still);
  const joint = w.add('MotorJoint', {
    body1: addBody(w, { angularVelocity: [1, 2, 3] }),
    autoCalc: true,
    motor1Axis: [0, 0, 0],
  });
  w.step(5);
  for (const n of [1, 2, 3])
    assert.deepEqual([joint.get(`motor${n}Angle`), joint.get(`motor${n}AngleRate`)], [0, 0]);
});

fact('contacts of page code leave the damping of unequal moments alone', async () => {
  const spun = async (given: boolean): Promise<number> => {
    const w = await world(still);
    const rod = addBody(w, {
      geometry: [box(4, 1, 1)],
      autoDamp: true,
      linearDampingFactor: 0,
      angularDampingFactor: 1,
      angularVelocity: [3, 0, 0],
    });
    const far = w.add('Contact', { body1: rod, position: [0, -5, 0], depth: -50 });
    for (let i = 0; i < 60; i++) {
      if (given) w.set('set_contacts', [far]);
      w.step();
    }
    return spin(rod)[0];
  };
  close(await spun(true), await spun(false), 1e-6, 'rad/s');
});

// ---- time -----------------------------------------------------------------------------------------------------------

fact('whatever is told of a step is told with the time at its end', async () => {
  const w = await world();
  const bob = addBody(w, { position: [1, 0, 0] });
  const hinge = addJoint(w, 'SingleAxisHingeJoint', {
    body1: bob,
    axis: [0, 0, 1],
    minAngle: -0.3,
  });
  let told: number | undefined;
  hinge.on('jointlimit', (detail) => (told = (detail as { time: number }).time));
  while (told === undefined && w.time < 2) w.step();
  close(told!, w.time, 1e-12, 's');
});

fact('a world that a listener resets within a step stands at time 0', async () => {
  const w = await world();
  addFloor(w);
  const ball = addBody(w, { position: [0, 0.7, 0] });
  let met = false;
  ball.on('collisionstart', () => {
    met = true;
    w.reset();
  });
  for (let i = 0; i < 100 && !met; i++) w.step();
  assert.deepEqual([met, w.time, position(ball)], [true, 0, [0, 0.7, 0]]);
});

fact('a collider that is removed filters nothing any more', async () => {
  const w = await world();
  addFloor(w);
  const ball = addBody(w, { position: [0, 0.5, 0] });
  const collider = w.add('CollisionCollection', { collidables: '*' });
  w.set('collider', collider);
  w.step(5);
  collider.remove();
  w.advance(0.5);
  close(height(ball), 0.5, 1e-3, 'm');
});

fact('a step for ever is none, and is told', async () => {
  const w = await world();
  claim(w, 'bad-value');
  assert.equal(w.step(Infinity), 0);
  assert.equal(w.advance(NaN), 0);
  assert.equal(w.time, 0);
});

fact('a world that ends ends its collisions', async () => {
  const w = await world();
  addFloor(w);
  const ball = addBody(w, { position: [0, 0.5, 0] });
  const reasons: unknown[] = [];
  ball.on('collisionend', (detail) => reasons.push((detail as { reason: string }).reason));
  w.advance(0.5);
  w.destroy();
  assert.deepEqual(reasons, ['removed']);
});

fact('a reset or a restore that wakes a sleeper says so', async () => {
  const w = await world({ rest: 'auto' });
  addFloor(w);
  const stone = addBody(w, { position: [0, 0.5, 0], geometry: [box(1)] });
  const told: string[] = [];
  for (const event of ['sleep', 'wake']) stone.on(event, () => told.push(event));
  const before = w.snapshot();
  w.advance(4);
  w.restore(before);
  w.advance(4);
  w.reset();
  assert.deepEqual(told, ['sleep', 'wake', 'sleep', 'wake']);
});

fact('a contact that applies what no parameter is called is told of', async () => {
  const w = await world();
  claim(w, 'bad-value');
  addFloor(w);
  const ball = addBody(w, { position: [0, 0.5, 0] });
  w.step();
  w.settings.event('set_contacts', [
    { type: 'Contact', body1: ball, appliedParameters: ['BOUNCY'] },
  ]);
  w.step();
  assert.ok(w.problems.some(({ message }) => message.includes('BOUNCY')));
});
