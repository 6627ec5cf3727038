import assert from 'node:assert/strict';
import type { World } from '../../physics-core/inside.js';
import {
  addBody,
  addFloor,
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
  type Node,
} from './helpers.js';

const shapeOf = (w: World, geometry: object = sphere(0.5), fields: object = {}): Node =>
  w.add('CollidableShape', { shape: [geometry], ...fields });

const offset = (x: number, collidable: Node) => ({
  type: 'CollidableOffset',
  translation: [x, 0, 0],
  collidable,
});

/** Whether two weightless balls, one inside the other, push each other apart. */
function meet(w: World, a: Body, b: Body, far: number): boolean {
  for (const [body, x] of [
    [a, 0],
    [b, 0.6],
  ] as const) {
    body.event('position', [x, far, 0]);
    body.event('linearVelocity', [0, 0, 0]);
    body.event('angularVelocity', [0, 0, 0]);
  }
  w.step(2);
  return Math.abs(position(b)[0] - position(a)[0] - 0.6) > 1e-4;
}

// ---- any number of collections -----------------------------------------------------------------------------------------

fact(
  '20 collections: exactly the pairs that no disabled collection alone speaks for collide',
  async () => {
    const w = await world({ gravity: [0, 0, 0] });
    const next = random(7);
    const shapes = Array.from({ length: 24 }, () => shapeOf(w));
    const bodies = shapes.map((shape, i) =>
      addBody(w, { geometry: [shape], position: [9, 10 * i, 0] }),
    );
    const lists = Array.from({ length: 20 }, () => shapes.filter(() => next() < 0.3));
    const enabled = lists.map(() => next() < 0.4);
    lists.forEach((collidables, i) =>
      w.add('CollisionCollection', { collidables, enabled: enabled[i] }),
    );
    const wrong: string[] = [];
    let apart = 0;
    for (let a = 0; a < shapes.length; a++) {
      for (let b = a + 1; b < shapes.length; b++) {
        const both = lists.flatMap((list, i) =>
          list.includes(shapes[a]!) && list.includes(shapes[b]!) ? [enabled[i]] : [],
        );
        const expected = both.length === 0 || both.includes(true);
        if (!expected) apart++;
        const far = 1000 + 10 * (a * shapes.length + b);
        if (meet(w, bodies[a]!, bodies[b]!, far) !== expected) wrong.push(`${a} ${b}`);
      }
    }
    assert.ok(apart > 40 && apart < 230, `${apart} pairs kept apart`);
    assert.deepEqual(wrong, []);
  },
);

fact('a collider in 20 collections: exactly its own pairs', async () => {
  const w = await world({ gravity: [0, 0, 0] });
  claim(w, 'not-in-collider');
  const shapes = Array.from({ length: 20 }, () => shapeOf(w));
  const bodies = shapes.map((shape, i) =>
    addBody(w, { geometry: [shape], position: [9, 10 * i, 0] }),
  );
  const collections = shapes.map((_, i) =>
    w.add('CollisionCollection', { collidables: shapes.slice(i) }),
  );
  w.set('collider', collections[10]);
  for (const [a, b, expected] of [
    [9, 12, false],
    [8, 9, false],
    [10, 19, true],
    [18, 19, true],
  ] as const)
    assert.equal(meet(w, bodies[a]!, bodies[b]!, 1000), expected, `${a} and ${b}`);
});

fact('a pair that was kept apart collides as soon as its collection is enabled', async () => {
  const w = await world();
  addFloor(w);
  for (let i = 0; i < 18; i++)
    w.add('CollisionCollection', { collidables: [shapeOf(w, sphere(0.5), { enabled: false })] });
  const [lower, upper] = [shapeOf(w), shapeOf(w)];
  const collection = w.add('CollisionCollection', {
    collidables: [lower, upper],
    enabled: false,
  });
  addBody(w, { fixed: true, position: [0, 2, 0], geometry: [lower] });
  const ball = addBody(w, { position: [0, 4, 0], geometry: [upper] });
  w.advance(2);
  close(height(ball), 0.5, 1e-3, 'm, through it');
  collection.set('enabled', true);
  ball.event('position', [0, 4, 0]);
  ball.event('linearVelocity', [0, 0, 0]);
  w.advance(1);
  close(height(ball), 3, 1e-2, 'm, on it');
});

// ---- membership is each collidable's own ---------------------------------------------------------------------------------

fact(
  'a part of a compound collides where it is in the collider, its other part does not',
  async () => {
    const w = await world();
    const [left, right, ground] = [shapeOf(w), shapeOf(w), shapeOf(w, box(20, 1, 20))];
    const collection = w.add('CollisionCollection', { collidables: [left, ground] });
    w.set('collider', collection);
    addBody(w, { fixed: true, position: [0, -0.5, 0], geometry: [ground] });
    // Its centre of mass lies above the left part, so it stands on that alone.
    const pair = addBody(w, {
      position: [0, 1, 0],
      centerOfMass: [-2, 0, 0],
      geometry: [offset(-2, left), offset(2, right)],
    });
    w.advance(1);
    close(height(pair), 0.5, 1e-2, 'm, on its left part');
    pair.event('orientation', [0, 0, 1, -0.5]);
    pair.event('position', [0, 1.6, 0]);
    pair.event('angularVelocity', [0, 0, 0]);
    w.step(2);
    const lowest = height(pair) - 2 * Math.sin(0.5) - 0.5;
    assert.ok(lowest < 0.2, 'the right part is about to dip in');
    pair.event('position', [0, 1.2, 0]);
    pair.event('linearVelocity', [0, 0, 0]);
    w.step(4);
    close(
      velocity(pair)[1],
      (-9.8 * 4) / 120,
      1e-2,
      'm/s, falling freely with its right part in the ground',
    );
  },
);

fact('offsets count with what they hold: either may be listed', async () => {
  for (const which of ['offset', 'shape']) {
    const w = await world();
    const shape = shapeOf(w);
    const holder = w.add('CollidableOffset', { translation: [0, 1, 0], collidable: shape });
    const ground = shapeOf(w, box(20, 1, 20));
    const listed = which === 'offset' ? holder : shape;
    w.set('collider', w.add('CollisionCollection', { collidables: [listed, ground] }));
    addBody(w, { fixed: true, position: [0, -0.5, 0], geometry: [ground] });
    const ball = addBody(w, { position: [0, 1, 0], geometry: [holder] });
    w.advance(2);
    close(height(ball), -0.5, 5e-3, `m, ${which} listed`);
  }
});

fact('a mesh among the parts of a fixed compound is told from the others', async () => {
  const w = await world();
  const plate = (y: number) => ({
    type: 'IndexedTriangleSet',
    coord: [-9, y, -9, 9, y, -9, 0, y, 9],
    index: [0, 2, 1],
  });
  const [upper, lower, block] = [shapeOf(w, plate(2)), shapeOf(w, plate(0)), shapeOf(w, box(1))];
  const shape = shapeOf(w);
  w.set('collider', w.add('CollisionCollection', { collidables: [lower, block, shape] }));
  addBody(w, { fixed: true, geometry: [upper, offset(6, block), lower] });
  const ball = addBody(w, { position: [0, 5, 0], geometry: [shape] });
  w.advance(3);
  close(height(ball), 0.5, 5e-3, 'm, through the upper plate, on the lower');
});

// ---- never -----------------------------------------------------------------------------------------------------------------

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

// ---- colliders that name one body only ---------------------------------------------------------------------------------------

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
    // By where exactly the wheels touch, friction is 0.2 to 0.8 % off (measured).
    close(velocity(chassis)[2] - v, a, 0.01 * a, 'm/s more in a second');
    close(position(chassis)[2] - z, v + a / 2, 0.01 * a, 'm on in a second');
    close(height(chassis), 0.5, 5e-3, 'm, on its wheels');
    // Bullet's friction comes one step late: a driven wheel slips by what its torque adds in a step, τ r dt / I.
    const slip = (3 * 0.4 * w.timeStep) / 0.08;
    wheels.forEach((wheel, i) => {
      const expected = velocity(chassis)[2] + (i < 2 ? 0 : slip);
      close(spin(wheel)[0] * 0.4, expected, 0.05, 'm/s, rolling');
    });
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
    claim(w, 'not-in-collider');
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

// ---- several collections of bodies -----------------------------------------------------------------------------------------

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
