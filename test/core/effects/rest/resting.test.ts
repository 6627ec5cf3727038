import assert from 'node:assert/strict';
import {
  addBody,
  addFloor,
  addJoint,
  box,
  close,
  fact,
  height,
  position,
  velocity,
  way,
  world,
  type Body,
} from '../../helpers.js';

/** A box asleep on the floor after the library's two seconds. */
async function asleep(fields: Record<string, unknown> = {}) {
  const w = await world({ rest: 'auto', ...fields });
  const slab = addFloor(w);
  const stone = addBody(w, { position: [0, 0.5, 0], geometry: [box(1)] });
  w.advance(4);
  assert.equal(stone.sleeping, true);
  return { w, slab, stone };
}

fact(
  'a box that nobody forbade to rests after two seconds, tells so, and stands still',
  async () => {
    const w = await world({ rest: 'auto' });
    addFloor(w);
    const stone = addBody(w, { position: [0, 0.5, 0], geometry: [box(1)] });
    const log: string[] = [];
    stone.on('sleep', () => log.push('sleep'));
    stone.on('wake', () => log.push('wake'));
    w.advance(1.9);
    assert.equal(stone.sleeping, false);
    w.advance(0.6);
    assert.equal(stone.sleeping, true);
    close(velocity(stone), [0, 0, 0], 0, 'm/s');
    stone.wake();
    assert.deepEqual(log, ['sleep', 'wake']);
  },
);

fact('a body that stands turned by 120° falls asleep as early as any other', async () => {
  const w = await world({ rest: 'auto', gravity: [0, 0, 0] });
  // At that angle Bullet's quaternion changes its sign; two of them turn through it in half a second and in one and a half.
  const bodies = [0.1, 1e-5, 3e-5].map((before, i) =>
    addBody(w, {
      position: [3 * i, 0, 0],
      orientation: [0, -1, 0, (2 * Math.PI) / 3 - before],
      angularVelocity: [0, -2e-5, 0],
      geometry: [box(1)],
    }),
  );
  w.advance(2.3);
  assert.deepEqual(
    bodies.map(({ sleeping }) => sleeping),
    [true, true, true],
  );
});

for (const [name, turn] of [
  ['straight', 0],
  ['each turned a little', 0.3],
] as const) {
  fact(`a stack of six boxes, ${name}, stands quiet at standard`, async () => {
    const w = await world();
    addFloor(w);
    const boxes = [0, 1, 2, 3, 4, 5].map((i) =>
      addBody(w, {
        position: [0, 0.5 + i, 0],
        orientation: [0, 1, 0, turn * i],
        geometry: [box(1)],
      }),
    );
    w.advance(10);
    for (let i = 0; i < 60; i++) {
      w.step();
      // 0.1 m/s before resting contacts kept 0.1 mm of depth.
      for (const stone of boxes) close(Math.hypot(...velocity(stone)), 0, 1e-3, 'm/s');
    }
    // A thousandth of its height: a stack sags by what the solver leaves of each overlap.
    close(height(boxes[5]!), 5.5, 5.5e-3, 'm');
  });
}

fact('a world in which nothing is awake needs no frame and moves no pose', async () => {
  const { w, stone } = await asleep();
  w.frame(1 / 60);
  assert.equal(w.frame(1 / 60), false);
  assert.equal(w.poses.movedCount, 0);
  assert.equal(w.stats.awake, 0);
  const at = position(stone);
  for (let i = 0; i < 60; i++) w.frame(1 / 60);
  close(position(stone), at, 0, 'm');
});

fact('an edit asks for a frame again, and the world calls for it', async () => {
  const { w, stone } = await asleep();
  while (w.frame(1 / 60));
  let calls = 0;
  w.onwork = () => calls++;
  stone.set('linearVelocity', [0, 3, 0]);
  assert.ok(calls > 0);
  assert.equal(w.stepping.needsFrame, true);
  assert.equal(w.frame(1 / 60), true);
  assert.equal(w.poses.movedCount, 1);
});

const WAKING: Record<string, (stone: Body) => void> = {
  linearVelocity: (stone) => stone.set('linearVelocity', [0, 2, 0]),
  angularVelocity: (stone) => stone.set('angularVelocity', [0, 2, 0]),
  position: (stone) => stone.set('position', [0, 2, 0]),
  orientation: (stone) => stone.set('orientation', [0, 0, 1, 0.3]),
  forces: (stone) => stone.set('forces', [[0, 20, 0]]),
  torques: (stone) => stone.set('torques', [[0, 2, 0]]),
  mass: (stone) => stone.set('mass', 2),
  geometry: (stone) => stone.set('geometry', [box(0.6)]),
  useGlobalGravity: (stone) => stone.set('useGlobalGravity', false),
  centerOfMass: (stone) => stone.set('centerOfMass', [0.7, 0, 0]),
  autoDisable: (stone) => stone.set('autoDisable', false),
  'applyForce()': (stone) => stone.applyForce([0, 100, 0]),
  'applyTorque()': (stone) => stone.applyTorque([0, 100, 0]),
  'applyImpulse()': (stone) => stone.applyImpulse([0, 2, 0]),
  'teleport()': (stone) => stone.teleport([0, 3, 0]),
  'wake()': (stone) => stone.wake(),
};

for (const [what, wake] of Object.entries(WAKING)) {
  fact(`a sleeping body wakes by ${what}`, async () => {
    const { w, stone } = await asleep();
    wake(stone);
    w.step();
    assert.equal(stone.sleeping, false);
    assert.equal(stone.body.isActive(), true);
  });
}

fact('a sleeping body wakes when another hits it', async () => {
  const { w, stone } = await asleep();
  const ball = addBody(w, { position: [-3, 0.5, 0], linearVelocity: [6, 0, 0] });
  w.advance(1);
  assert.equal(stone.sleeping, false);
  assert.ok(position(stone)[0] > 0.2, 'it was pushed');
  assert.ok(velocity(ball)[0] < 5);
});

fact(
  'a sleeping body wakes and falls when its support goes, is taken out, jumps or changes shape',
  async () => {
    const ways: Record<string, (slab: Body) => void> = {
      remove: (slab) => slab.remove(),
      disable: (slab) => slab.set('enabled', false),
      teleport: (slab) => slab.teleport([0, -50, 0]),
      shrink: (slab) => slab.set('geometry', [box(0.1)]),
    };
    for (const [what, take] of Object.entries(ways)) {
      const { w, slab, stone } = await asleep();
      take(slab);
      w.advance(0.3);
      close(height(stone), 0.5 - way(9.8, 0.3), 5e-3, `m, after ${what}`);
    }
  },
);

for (const byHand of [false, true])
  fact(
    `what lies on a sleeping body that jumps away falls${byHand ? ', put to sleep by hand too' : ''}`,
    async () => {
      const { w, stone } = await asleep();
      const upper = addBody(w, { position: [0, 1.5, 0], geometry: [box(1)] });
      const aside = addBody(w, { position: [5, 0.5, 0], geometry: [box(1)] });
      w.advance(0.5);
      if (byHand) upper.sleep();
      w.advance(4);
      assert.deepEqual([stone.sleeping, upper.sleeping, aside.sleeping], [true, true, true]);
      stone.set('position', [20, 0.5, 0]);
      w.step();
      assert.deepEqual([stone.sleeping, upper.sleeping, aside.sleeping], [false, false, true]);
      w.advance(1);
      close(height(upper), 0.5, 5e-3, 'm');
    },
  );

fact('a sleeping body wakes when gravity changes', async () => {
  const { w, stone } = await asleep();
  w.set('gravity', [0, 5, 0]);
  w.advance(0.5);
  close(height(stone), 0.5 + way(5, 0.5), 5e-3, 'm');
});

fact('a sleeping body wakes when the parameters of its contacts change', async () => {
  const { w, stone } = await asleep({ gravity: [3, -9.8, 0] });
  const collection = w.add('CollisionCollection', {
    collidables: '*',
    frictionCoefficients: [1, 1],
  });
  w.advance(4);
  assert.equal(stone.sleeping, true);
  const [x] = position(stone);
  collection.set('frictionCoefficients', [0, 0]);
  w.advance(0.5);
  close(position(stone)[0] - x, way(3, 0.5), 1e-3, 'm, it slides');
});

fact('a sleeping body wakes when a joint takes hold of it, changes or lets go', async () => {
  const { w, stone } = await asleep();
  const motor = w.add('MotorJoint', { body1: stone });
  w.advance(4);
  motor.set('motor1Axis', [0, 1, 0]);
  motor.set('axis1Torque', 5);
  w.advance(0.5);
  assert.ok(Math.abs((stone.get('angularVelocity') as number[])[1]!) > 0.5);
});

fact('a hanging body falls when its joint goes, asleep as it was', async () => {
  const w = await world({ rest: 'auto' });
  const ball = addBody(w);
  const joint = addJoint(w, 'BallJoint', { body1: ball, anchorPoint: [0, 1, 0] });
  w.advance(4);
  assert.equal(ball.sleeping, true);
  joint.remove();
  w.advance(0.5);
  close(height(ball), -way(9.8, 0.5), 2e-3, 'm');
});

for (const [what, act] of [
  ['is removed', (low: Body) => low.remove()],
  ['is disabled', (low: Body) => low.set('enabled', false)],
  ['is put elsewhere', (low: Body) => low.teleport([5, 0.5, 0])],
] as const)
  fact(`what slept on a body that slept, too, falls when that one ${what}`, async () => {
    const { w, stone } = await asleep();
    const high = addBody(w, { position: [0, 1.5, 0], geometry: [box(1)] });
    w.advance(4);
    assert.deepEqual([stone.sleeping, high.sleeping], [true, true]);
    act(stone);
    w.advance(3);
    close(height(high), 0.5, 1e-3, 'm');
  });

fact(
  'what slept as it hung on a body that slept, too, falls when that one is removed',
  async () => {
    const w = await world({ rest: 'auto' });
    const [high, low] = [addBody(w), addBody(w, { position: [0, -1, 0] })];
    addJoint(w, 'BallJoint', { body1: high, anchorPoint: [0, 1, 0] });
    addJoint(w, 'BallJoint', { body1: high, body2: low, anchorPoint: [0, -0.5, 0] });
    w.advance(4);
    assert.deepEqual([high.sleeping, low.sleeping], [true, true]);
    high.remove();
    w.advance(0.5);
    close(height(low), -1 - way(9.8, 0.5), 2e-3, 'm');
  },
);

fact('one restless body keeps all of its island awake', async () => {
  const w = await world({ rest: 'auto' });
  addFloor(w);
  const low = addBody(w, { position: [0, 0.5, 0], geometry: [box(1)] });
  const high = addBody(w, { position: [0, 1.5, 0], geometry: [box(1)], autoDisable: false });
  const apart = addBody(w, { position: [5, 0.5, 0], geometry: [box(1)] });
  w.advance(5);
  assert.deepEqual([low.sleeping, high.sleeping, apart.sleeping], [false, false, true]);
  high.set('autoDisable', true);
  high.set('disableLinearSpeed', 1);
  high.set('disableAngularSpeed', 1);
  w.advance(3);
  assert.deepEqual([low.sleeping, high.sleeping], [true, true]);
});

fact('a slow slide, a slow turn and a free drift are not taken for rest', async () => {
  const w = await world({ rest: 'auto', gravity: [0, 0, 0] });
  const drifting = addBody(w, { linearVelocity: [0.005, 0, 0] });
  const turning = addBody(w, { position: [5, 0, 0], angularVelocity: [0, 0.005, 0] });
  w.advance(10);
  close(position(drifting)[0], 0.05, 1e-4, 'm');
  close((turning.get('orientation') as number[])[3]!, 0.05, 1e-4, 'rad');
});
