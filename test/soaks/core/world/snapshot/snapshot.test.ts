import assert from 'node:assert/strict';
import type { World } from '../../../../../physics-core/inside.js';
import {
  addBody,
  addFloor,
  addJoint,
  box,
  claim,
  close,
  fact,
  height,
  position,
  random,
  sphere,
  spin,
  velocity,
  way,
  world,
  type Body,
  overflow,
} from '../../../../core/helpers.js';

/** Everything that moves, to the last bit. */
const stateOf = (bodies: Body[]): number[] =>
  bodies.flatMap((body) => [
    ...position(body),
    ...(body.get('orientation') as number[]),
    ...velocity(body),
    ...spin(body),
  ]);

/** A heap of boxes and balls, a chain, and a driven hinge. */
async function busy(): Promise<{ w: World; bodies: Body[] }> {
  const w = await world();
  addFloor(w);
  w.add('CollisionCollection', { collidables: '*', bounce: 0.3, frictionCoefficients: [0.6, 0.6] });
  const next = random(3);
  const bodies = Array.from({ length: 30 }, (_, i) =>
    addBody(w, {
      position: [next() * 2, 0.6 + i, next() * 2],
      orientation: [next(), next(), next(), next() * 3],
      geometry: [i % 2 ? sphere(0.3) : box(0.5)],
    }),
  );
  let last: Body | undefined;
  for (let i = 0; i < 5; i++) {
    const link = addBody(w, { position: [5 + i, 6, 0], geometry: [sphere(0.2)] });
    w.add('BallJoint', {
      body1: link,
      ...(last ? { body2: last } : {}),
      anchorPoint: [4.5 + i, 6, 0],
    });
    bodies.push((last = link));
  }
  const wheel = addBody(w, { position: [-5, 3, 0], torques: [[0, 0, 1]] });
  addJoint(w, 'SingleAxisHingeJoint', {
    body1: wheel,
    axis: [0, 0, 1],
    anchorPoint: [-5, 2, 0],
    minAngle: -0.5,
    maxAngle: 0.5,
    stopBounce: 0.5,
  });
  return { w, bodies: [...bodies, wheel] };
}

fact(
  'two restores of one snapshot run alike, bit for bit, through contacts and joints',
  async () => {
    const { w, bodies } = await busy();
    w.advance(1.5);
    const kept = structuredClone(w.snapshot());
    const at = stateOf(bodies);
    const runs = [0, 1, 2].map((run) => {
      w.step(37 * run);
      w.restore(kept);
      close(stateOf(bodies), at, 1e-6, 'as it was');
      w.advance(1);
      return stateOf(bodies);
    });
    assert.deepEqual(runs[1], runs[0]);
    assert.deepEqual(runs[2], runs[0]);
    close(w.time, 2.5, 1e-9, 's');
  },
);

fact('taking a snapshot changes nothing', async () => {
  const ends: number[][] = [];
  for (const take of [false, true]) {
    const { w, bodies } = await busy();
    w.advance(0.5);
    if (take) w.snapshot();
    w.advance(0.5);
    ends.push(stateOf(bodies));
  }
  assert.deepEqual(ends[1], ends[0]);
});

fact('a free flight goes on from a restore as it went on from the snapshot', async () => {
  const w = await world();
  const ball = addBody(w, {
    position: [0, 9, 0],
    linearVelocity: [2, 3, 0],
    centerOfMass: [0.1, 0, 0],
  });
  w.advance(0.5);
  const kept = w.snapshot();
  w.advance(0.5);
  const end = stateOf([ball]);
  w.restore(kept);
  w.advance(0.5);
  close(stateOf([ball]), end, 1e-5, 'the same end');
});

fact('a pendulum swings on from a restore as it swung on from the snapshot', async () => {
  const w = await world();
  const ball = addBody(w, { position: [1, 0, 0], geometry: [sphere(0.1)] });
  addJoint(w, 'BallJoint', { body1: ball });
  w.advance(0.3);
  const taken = w.snapshot();
  w.advance(1);
  const on = position(ball);
  w.restore(taken);
  w.advance(1);
  // Poses in single precision.
  close(position(ball), on, 1e-5, 'm');
});

fact('field values, authored or by event, and the level come back', async () => {
  const w = await world();
  const ball = addBody(w, { mass: 2 });
  ball.event('mass', 3);
  w.step();
  const kept = w.snapshot();
  ball.set('mass', 7);
  ball.set('linearDampingFactor', 0.5);
  w.accuracy = 'precise';
  w.step();
  w.restore(kept);
  assert.equal(ball.get('mass'), 3);
  assert.equal(ball.get('linearDampingFactor'), 0.001);
  assert.equal(ball.authored('linearDampingFactor'), false);
  assert.equal(w.accuracy, 'standard');
  close(w.time, 1 / 120, 1e-12, 's');
  w.reset();
  assert.equal(ball.get('mass'), 2, 'the event is still known as one');
});

fact('sleep and the time to it come back, without a word where nothing changes', async () => {
  const w = await world({ rest: 'auto' });
  const ball = addBody(w, {
    autoDisable: true,
    disableTime: 1,
    disableLinearSpeed: 1,
    disableAngularSpeed: 1,
  });
  ball.set('useGlobalGravity', false);
  const events: string[] = [];
  for (const name of ['sleep', 'wake']) ball.on(name, () => events.push(name));
  w.advance(0.6);
  const almost = w.snapshot();
  w.advance(2);
  const asleep = w.snapshot();
  assert.deepEqual(events, ['sleep']);
  w.restore(asleep);
  assert.equal(ball.sleeping, true);
  assert.deepEqual(events, ['sleep']);
  w.restore(almost);
  assert.equal(ball.sleeping, false);
  w.advance(0.25);
  assert.equal(ball.sleeping, false, 'at 0.85 s');
  w.advance(0.5);
  assert.equal(ball.sleeping, true, 'at 1.35 s');
});

fact('what applyForce asked of the next step comes back', async () => {
  const w = await world({ gravity: [0, 0, 0] });
  const ball = addBody(w);
  w.step();
  ball.applyForce([120, 0, 0]);
  const kept = w.snapshot();
  w.step();
  close(velocity(ball), [1, 0, 0], 1e-6, 'm/s');
  w.restore(kept);
  close(velocity(ball), [0, 0, 0], 0, 'm/s');
  w.step(3);
  close(velocity(ball), [1, 0, 0], 1e-6, 'm/s, once');
});

fact('a joint keeps its zero: an angle reads on from where it was', async () => {
  const w = await world({ gravity: [0, 0, 0] });
  const body = addBody(w, { position: [1, 0, 0] });
  const hinge = addJoint(w, 'SingleAxisHingeJoint', {
    body1: body,
    axis: [0, 0, 1],
    forceOutput: ['ALL'],
  });
  w.step();
  body.event('angularVelocity', [0, 0, 1]);
  body.event('linearVelocity', [0, 1, 0]);
  w.advance(0.5);
  const angle = hinge.get('angle') as number;
  close(angle, 0.5, 0.01, 'rad');
  const kept = w.snapshot();
  w.advance(0.5);
  w.restore(kept);
  w.step();
  close(hinge.get('angle') as number, angle + 1 / 120, 1e-3, 'rad');
});

fact('nodes that came since start from their markup, nodes that went stay away', async () => {
  const w = await world();
  addFloor(w);
  const first = addBody(w, { position: [0, 9, 0] });
  const gone = addBody(w, { position: [3, 9, 0] });
  w.advance(0.5);
  const kept = w.snapshot();
  gone.remove();
  const late = addBody(w, { position: [6, 9, 0] });
  first.set('geometry', [box(3)]);
  w.advance(0.5);
  w.restore(kept);
  close(height(first), 9 - way(9.8, 0.5), 1e-4, 'm, restored');
  close(height(late), 9, 1e-6, 'm, at its start');
  assert.equal(w.stats.bodies, 3);
  w.advance(3);
  close(height(first), 0.5, 1e-3, 'm, with the shape it had');
});

fact(
  'a body that broke is broken after its restore, and sound after that of an earlier one',
  async () => {
    const w = await world();
    claim(w, 'nan-state');
    const ball = addBody(w, { mass: 0.1, position: [0, 9, 0] });
    w.advance(0.1);
    const sound = w.snapshot();
    overflow(ball, [1e38, 0, 0]);
    w.step();
    assert.equal(ball.parked, true);
    const broken = w.snapshot();
    w.restore(sound);
    assert.equal(ball.parked, false);
    w.restore(broken);
    assert.equal(ball.parked, true);
  },
);

fact('contacts that listeners know of end with the reason reset', async () => {
  const w = await world();
  addFloor(w);
  const ball = addBody(w, { position: [0, 0.5, 0] });
  const reasons: unknown[] = [];
  ball.on('collisionend', (detail) => reasons.push((detail as { reason: string }).reason));
  w.advance(0.5);
  const kept = w.snapshot();
  w.restore(kept);
  assert.deepEqual(reasons, ['reset']);
});

fact('something else than a snapshot is reported and does nothing', async () => {
  const w = await world();
  claim(w, 'bad-value');
  const ball = addBody(w, { position: [0, 9, 0] });
  w.advance(0.5);
  const at = position(ball);
  w.restore({} as never);
  w.restore(null as never);
  assert.deepEqual(position(ball), at);
});
