import assert from 'node:assert/strict';
import {
  addBody,
  box,
  claim,
  close,
  fact,
  height,
  position,
  spin,
  velocity,
  world,
} from '../../../../core/helpers.js';
import { shapeOf } from '../../../../core/world/pairs/scenes.js';

/** sim-vehicle: a chassis of 5 kg on four wheels of 1 kg, 0.4 m, the rear ones driven by 3 N·m each. */
async function car(collider: Record<string, unknown>, strict = false) {
  const w = await world({ accuracy: 'fine', ...(strict ? { collisionRules: 'strict' } : {}) });
  const ground = shapeOf(w, box(50, 1, 50));
  const collection = w.add('CollisionCollection', { collidables: [ground], ...collider });
  w.set('collider', collection);
  addBody(w, { fixed: true, position: [0, -0.5, 0], geometry: [ground] });
  const chassis = addBody(w, { mass: 5, position: [0, 0.5, 0], geometry: [box(1, 0.4, 2)] });
  const wheels = [
    [-0.6, 0.8],
    [0.6, 0.8],
    [-0.6, -0.8],
    [0.6, -0.8],
  ].map(([x, z]) => {
    const wheel = addBody(w, {
      position: [x, 0.4, z],
      orientation: [0, 0, 1, -1.5708],
      geometry: [{ type: 'Cylinder', radius: 0.4, height: 0.2 }],
      torques: z! < 0 ? [[3, 0, 0]] : [],
    });
    w.add('SingleAxisHingeJoint', {
      axis: [1, 0, 0],
      anchorPoint: [x, 0.4, z],
      body1: wheel,
      body2: chassis,
    });
    return wheel;
  });
  return { w, chassis, wheels, collection, ground };
}

const TYRES = {
  frictionCoefficients: [1, 1],
  appliedParameters: ['BOUNCE', 'FRICTION_COEFFICIENT-2'],
};

fact(
  'a collider that lists the ground only, with its friction: the car drives, a = τ r / (M r² + 4 I)',
  async () => {
    const { w, chassis, wheels } = await car(TYRES);
    claim(w, 'one-sided-collider');
    w.advance(0.5);
    const [z, v] = [position(chassis)[2], velocity(chassis)[2]];
    w.advance(1);
    // 9 kg on wheels of m r²/2 = 0.08 kg·m²; both driven wheels together 6 N·m.
    const a = (6 * 0.4) / (9 * 0.16 + 4 * 0.08);
    close(velocity(chassis)[2] - v, a, 0.001 * a, 'm/s more in a second');
    close(position(chassis)[2] - z, v + a / 2, 0.01 * a, 'm on in a second');
    close(height(chassis), 0.5, 5e-3, 'm, on its wheels');
    for (const wheel of wheels)
      close(spin(wheel)[0] * 0.4, velocity(chassis)[2], 1e-3, 'm/s, rolling');
    const told = w.problems.filter(({ code }) => code === 'one-sided-collider');
    assert.equal(told.length, 1);
  },
);

fact('without parameters, under strict rules, or with an empty list nothing collides', async () => {
  for (const [fields, strict] of [
    [{}, false],
    [TYRES, true],
    [{ ...TYRES, collidables: [] }, false],
  ] as const) {
    const { w, chassis } = await car(fields, strict);
    claim(w, 'not-in-collider', ...('collidables' in fields ? ['idle-collection'] : []));
    w.advance(0.5);
    close(height(chassis), 0.5 - 9.8 / 8, 5e-3, 'm');
  }
});

fact(
  'a one-sided collider stops being one when a second body is listed, or its parameters go',
  async () => {
    const { w, chassis, collection, ground } = await car(TYRES);
    claim(w, 'one-sided-collider', 'not-in-collider');
    const other = shapeOf(w);
    const ball = addBody(w, { position: [9, 0.5, 9], geometry: [other] });
    w.advance(0.2);
    collection.set('collidables', [ground, other]);
    w.advance(0.5);
    close(height(ball), 0.5, 1e-3, 'm, listed');
    assert.ok(height(chassis) < 0, 'the car falls through');
    assert.ok(!w.problems.some(({ code }) => code === 'one-sided-collider'));
    collection.set('collidables', [ground]);
    ball.event('position', [9, 0.5, 9]);
    w.advance(0.2);
    close(height(ball), 0.5, 1e-2, 'm, one-sided again');
    collection.unset('frictionCoefficients');
    collection.unset('appliedParameters');
    w.advance(0.5);
    assert.ok(height(ball) < 0, 'no parameters: nothing collides');
  },
);
