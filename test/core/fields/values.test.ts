import assert from 'node:assert/strict';
import { createWorld } from '../../../physics-core/create.js';
import {
  addBody,
  claim,
  close,
  fact,
  position,
  sphere,
  watch,
  world,
  type Body,
  WEIGHTLESS,
  told,
} from '../helpers.js';

fact(
  'numbers too large for products of single precision are refused wherever they come in, with the bound',
  async () => {
    const w = await world(WEIGHTLESS);
    claim(w, 'out-of-range', 'bad-value');
    const ball = addBody(w);
    w.step();
    const refused = (field: string, value: unknown, bound = '±1e12'): void => {
      const before = ball.get(field);
      ball.set(field, value);
      assert.deepEqual(ball.get(field), before, field);
      assert.ok(told(w, 'out-of-range')[0]!.includes(`beyond ${bound},`), field);
      w.settle(ball);
    };
    refused('mass', 1e39);
    refused('mass', 1.1e12);
    refused('linearVelocity', [0, 1e30, 0]);
    refused('angularVelocity', [0, 1e7, 0], '±1e6');
    refused('forces', [[1e15, 0, 0]]);
    refused('mass', '1e39');
    refused('position', [0, -1e39, 0]);
    refused('orientation', [1e39, 0, 0, 1]);
    refused('inertia', [1e39, 0, 0, 0, 1, 0, 0, 0, 1], '±1e24');
    refused('torques', [[0, 0, 0], [0, 1e39, 0]], '±1e24'); // prettier-ignore
    w.set('gravity', [0, 1e300, 0]);
    assert.equal(told(w, 'out-of-range').length, 1);
    // X3D's times are of double precision.
    ball.set('disableTime', 1e39);
    assert.equal(ball.get('disableTime'), 1e39);
    for (const mass of [1e12, 1e-12]) {
      ball.set('mass', mass);
      assert.equal(ball.get('mass'), mass);
    }
    w.settle(w.settings);
    ball.set('mass', 1e-13);
    assert.match(told(w, 'out-of-range')[0]!, /mass="1e-13" is below 1e-12, .* 1e-12 is used/);
    ball.set('mass', 1);
    for (const call of [
      () => ball.applyForce([1e39, 0, 0]),
      () => ball.applyForce([1, 0, 0], [1e39, 0, 0]),
      () => ball.applyTorque([1e39, 0, 0]),
      () => ball.applyImpulse([1e39, 0, 0]),
      () => ball.teleport([1e39, 0, 0]),
      () => ball.teleport([0, 0, 0], undefined, { linearVelocity: [1e39, 0, 0] }),
      () => ball.drag([1e39, 0, 0]),
      () => w.raycast([1e39, 0, 0], [0, 0, 0]),
    ]) {
      w.settle(ball);
      w.settle(w);
      call();
      assert.match(told(w, 'bad-value')[0]!, /finite numbers up to 1e12/, String(call));
    }
    const drag = ball.drag([0, 0, 0])!;
    drag.move([NaN, 0, 0]);
    w.step(12);
    drag.end();
    close(position(ball), [0, 0, 0], 1e-6, 'm');
    const tight = watch(await createWorld({ maxHeapBytes: NaN }));
    claim(tight, 'bad-value');
    assert.match(told(tight, 'bad-value')[0]!, /maxHeapBytes takes a number above 0, not NaN/);
    addBody(tight);
    tight.step();
    assert.equal(tight.stats.bodies, 1);
  },
);

fact(
  'a start beyond single precision, as of a Transform far away, is told and not taken',
  async () => {
    const w = await world(WEIGHTLESS);
    claim(w, 'out-of-range');
    const start = { p: [0, 1e39, 0] as [number, number, number], q: [0, 0, 0, 1] as never };
    const ball = w.add('RigidBody', { geometry: sphere(1) }, { start }) as Body;
    w.step();
    assert.deepEqual(position(ball), [0, 0, 0]);
  },
);

fact('a 32-bit integer is no fraction and no more than 32 bits', async () => {
  const w = await world();
  claim(w, 'bad-value');
  for (const value of [1.5, 2 ** 31, '1e10']) w.set('iterations', value);
  assert.equal(w.get('iterations'), 10);
  // A fraction among the indices of a mesh points between two points.
  const mesh = {
    type: 'IndexedTriangleSet',
    coord: [0, 0, 0, 1, 0, 0, 0, 1, 0],
    index: [0, 0.5, 2],
  };
  const body = addBody(w, { geometry: [sphere(0.5), mesh] });
  w.step();
  assert.equal(body.parts.length, 1);
});
