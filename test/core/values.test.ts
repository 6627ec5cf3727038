import assert from 'node:assert/strict';
import { createWorld, nodeTypes, type World } from '../../physics-core/inside.js';
import { show } from '../../physics-core/base/show.js';
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
  sphere,
  spin,
  velocity,
  watch,
  way,
  world,
  type Body,
} from './helpers.js';

const WEIGHTLESS = { gravity: [0, 0, 0] };

const told = (w: World, code: string): string[] =>
  w.problems.filter((problem) => problem.code === code).map(({ message }) => message);

/** kg m² about x, by what a torque makes of the spin in one step. */
function inertia(body: Body): number {
  const [before] = spin(body);
  body.applyTorque([100, 0, 0]);
  (body.world as World).step();
  return (100 * body.world.timeStep) / (spin(body)[0] - before);
}

// ---- what is no value ----------------------------------------------------------------------------------------------

fact('a massDensityModel that is none leaves the body the inertia of its geometry', async () => {
  const w = await world(WEIGHTLESS);
  claim(w, 'bad-value', 'misplaced');
  const plain = addBody(w, { geometry: [box(1, 2, 3)] });
  const models = [
    { type: 'Sphere', radius: Infinity },
    { type: 'Sphere', radius: 1e39 },
    { type: 'Box', size: [1, NaN, 1] },
    { type: 'Banana' },
    { type: 'BallJoint' },
    { radius: 1 },
    'Sphere',
    plain,
  ];
  const bodies = models.map((massDensityModel, i) =>
    addBody(w, { massDensityModel, position: [9 * (i + 1), 0, 0], geometry: [box(1, 2, 3)] }),
  );
  w.advance(0.5);
  assert.equal(w.paused, false);
  for (const body of bodies) {
    close(inertia(body), 13 / 12, 1e-4, 'kg m²');
    assert.equal(w.problemsOf(body).length, 1);
    assert.equal(w.problemsOf(body)[0]!.attribute, 'massDensityModel');
    body.set('massDensityModel', sphere(2));
    w.step(0);
    assert.deepEqual(w.problemsOf(body), [], 'mended');
    close(inertia(body), 1.6, 1e-4, 'kg m²');
  }
});

fact(
  'numbers beyond single precision are refused wherever they come in, with the bound',
  async () => {
    const w = await world(WEIGHTLESS);
    claim(w, 'out-of-range', 'bad-value');
    const ball = addBody(w);
    w.step();
    const refused = (field: string, value: unknown): void => {
      const before = ball.get(field);
      ball.set(field, value);
      assert.deepEqual(ball.get(field), before, field);
      assert.match(told(w, 'out-of-range')[0]!, /beyond ±3.4e38/);
      w.settle(ball);
    };
    refused('mass', 1e39);
    refused('mass', '1e39');
    refused('position', [0, -1e39, 0]);
    refused('orientation', [1e39, 0, 0, 1]);
    refused('inertia', [1e39, 0, 0, 0, 1, 0, 0, 0, 1]);
    refused('torques', [[0, 0, 0], [0, 1e39, 0]]); // prettier-ignore
    w.set('gravity', [0, 1e300, 0]);
    assert.equal(told(w, 'out-of-range').length, 1);
    // X3D's times are of double precision.
    ball.set('disableTime', 1e39);
    assert.equal(ball.get('disableTime'), 1e39);
    ball.set('mass', 3.4e38);
    assert.equal(ball.get('mass'), 3.4e38);
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
      assert.match(told(w, 'bad-value')[0]!, /finite numbers below 3.4e38/, String(call));
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

fact('names that every object of JavaScript has are no fields, node types or nodes', async () => {
  const w = await world();
  claim(w, 'unknown-attribute', 'no-body');
  const names = ['constructor', 'toString', '__proto__', 'hasOwnProperty', 'valueOf'];
  for (const type of Object.keys(nodeTypes)) {
    const node = w.add(type);
    for (const name of names) {
      node.set(name, 1);
      node.event(name, 1);
      node.unset(name);
      assert.equal(node.get(name), undefined);
    }
    const found = w.problemsOf(node).map(({ code, attribute }) => [code, attribute]);
    assert.deepEqual(found, names.map((name) => ['unknown-attribute', name])); // prettier-ignore
    w.settle(node);
  }
  w.set('constructor', 1);
  for (const name of names) {
    assert.throws(() => w.add(name), /no node type/);
    assert.equal(w.node(name), undefined);
  }
  w.step();
});

fact('an unknown field is told with the one that was meant', async () => {
  const w = await world();
  claim(w, 'unknown-attribute');
  const ball = addBody(w, { linearvelocity: [1, 0, 0], masss: 2, weightOfTheThing: 3 });
  assert.deepEqual(told(w, 'unknown-attribute'), [
    'RigidBody has no field linearvelocity; did you mean linearVelocity?',
    'RigidBody has no field masss; did you mean mass?',
    'RigidBody has no field weightOfTheThing',
  ]);
  ball.set('x'.repeat(10_000), 1);
  assert.ok(told(w, 'unknown-attribute').every(({ length }) => length < 120));
});

fact('nobody is asked for by nothing', async () => {
  const w = await world();
  const ball = addBody(w);
  assert.equal(w.node(undefined), undefined);
  assert.equal(w.node(null), undefined);
  assert.equal(w.node(ball.id), ball);
});

// ---- nodes ---------------------------------------------------------------------------------------------------------

fact('one node is as good as a list of one, and a list of one as one node', async () => {
  const w = await world();
  addFloor(w);
  const shape = w.add('CollidableShape', { shape: box(1) });
  const bodies = [
    addBody(w, { position: [0, 0.5, 0], geometry: shape }),
    addBody(w, { position: [3, 0.5, 0], geometry: box(1) }),
    addBody(w, {
      position: [6, 1.5, 0],
      geometry: { type: 'CollidableOffset', translation: [0, -1, 0], collidable: [box(1)] },
    }),
  ];
  const hung = addBody(w, { position: [9, 5, 0] });
  addJoint(w, 'BallJoint', { body1: [hung], anchorPoint: [9, 5, 0] });
  w.set('collider', [w.add('CollisionCollection', { collidables: '*' })]);
  w.advance(1);
  close(bodies.map(height), [0.5, 0.5, 1.5], 2e-3, 'm, on the floor');
  close(height(hung), 5, 1e-3, 'm');
  assert.deepEqual(shape.get('shape'), [box(1)]);
  assert.deepEqual(bodies[0]!.get('geometry'), [shape]);
});

fact('geometry is copied, and data that say the same again are no edit', async () => {
  const w = await world();
  const given = { type: 'Sphere', radius: 0.5 };
  const shape = w.add('CollidableShape', { shape: given });
  const body = addBody(w, { geometry: shape, massDensityModel: box(1, 2, 3) });
  w.step();
  const { patched } = w.stats;
  for (let i = 0; i < 10; i++) {
    shape.set('shape', [{ type: 'Sphere', radius: 0.5 }]);
    body.set('massDensityModel', box(1, 2, 3));
  }
  w.step(0);
  assert.equal(w.stats.patched, patched);
  given.radius = NaN;
  body.set('mass', 2);
  w.advance(0.5);
  close(height(body), -way(9.8, 61 / 120), 0.05, 'm');
});

fact('what a field of nodes does not take is told and left out, and nothing breaks', async () => {
  const w = await world();
  claim(w, 'misplaced', 'bad-value', 'no-body');
  const other = watch(await createWorld());
  const [here, there] = [addBody(w), addBody(other)];
  const space = w.add('CollisionSpace', {});
  const misplaced: [type: string, field: string, value: unknown, message: RegExp][] = [
    ['RigidBody', 'geometry', [here], /geometry: RigidBody is no CollidableShape or/],
    ['RigidBody', 'geometry', [5, 'x'], /geometry: (5|x) is no CollidableShape/],
    ['RigidBody', 'geometry', { size: [1, 1, 1] }, /geometry: \{ size: 1 1 1 \} is no/],
    ['RigidBody', 'geometry', { type: 'Banana' }, /geometry: \{ type: Banana \} is no/],
    ['BallJoint', 'body1', there, /body1: RigidBody stands in another world; it is left out/],
    ['BallJoint', 'body1', space, /body1: CollisionSpace is no RigidBody;/],
    ['CollisionCollection', 'collidables', [here], /collidables: RigidBody is no/],
    ['CollisionSensor', 'collider', space, /collider: CollisionSpace is no/],
    ['CollidableOffset', 'collidable', new Date(), /collidable: a Date is no/],
  ];
  for (const [type, field, value, message] of misplaced) {
    const node = w.add(type, { [field]: value });
    w.step();
    const [problem] = w.problemsOf(node).filter(({ code }) => code === 'misplaced');
    assert.match(problem!.message, message);
    assert.equal(problem!.attribute, field);
    node.unset(field);
    assert.deepEqual(w.problemsOf(node).filter(({ code }) => code === 'misplaced'), []); // prettier-ignore
  }
  for (const field of ['geometry', 'forces']) {
    here.set(field, '*');
    assert.match(told(w, 'bad-value')[0]!, new RegExp(`${field}="\\*" is not MF`));
    w.settle(here);
  }
  w.step();
  assert.equal(w.paused, false);
});

fact(
  'collidables that stand in each other in a circle, or data that hold themselves, end',
  async () => {
    const w = await world();
    claim(w, 'misplaced');
    const [outer, inner] = [w.add('CollidableOffset'), w.add('CollidableOffset')];
    outer.set('collidable', inner);
    const ball = addBody(w, { geometry: [outer, sphere(0.5)] });
    w.step();
    inner.set('collidable', outer);
    w.step();
    assert.match(
      told(w, 'misplaced')[0]!,
      /can't hold CollidableOffset, in which it stands itself/,
    );
    inner.set('collidable', box(1));
    w.step();
    assert.deepEqual(w.problems, []);
    assert.equal(ball.parts.length, 2);
    const itself: Record<string, unknown> = { type: 'CollidableOffset' };
    itself.collidable = itself;
    ball.set('geometry', itself);
    w.step();
    assert.equal(told(w, 'misplaced').length, 1);
  },
);

// ---- messages ------------------------------------------------------------------------------------------------------

fact(
  'messages show what was given, shortly, and never an empty value as the one that is used',
  async () => {
    const cyclic: Record<string, unknown> = { type: 'Box' };
    cyclic.size = cyclic;
    const given = [
      {},
      { type: 'Box', size: [1, 2, 3] },
      cyclic,
      Object.create(null),
      new Map(),
      () => 1,
      Symbol('s'),
      10n,
      null,
      undefined,
      [],
      'x'.repeat(9999),
      Array.from({ length: 9999 }, (_, i) => i),
      new Float32Array(9999),
    ];
    for (const value of given) {
      assert.ok(show(value).length <= 60 && show(value).length > 0, show(value));
      assert.doesNotMatch(show(value), /\[object/);
    }
    assert.equal(show({ type: 'Box', size: [1, 2, 3] }), '{ type: Box, size: 1 2 3 }');
    assert.equal(show(new Float32Array([1, 2])), '1 2');
    const w = await world();
    const messages: string[] = [];
    w.on('problem', (problem) => messages.push((problem as { message: string }).message));
    claim(w, 'bad-value', 'misplaced');
    for (const type of Object.keys(nodeTypes)) {
      const node = w.add(type);
      for (const [field, { access }] of Object.entries(nodeTypes[type]!.fields))
        if (access !== 'outputOnly') for (const value of given) node.set(field, value);
      if (type !== 'RigidBodyCollection') node.remove();
    }
    assert.ok(messages.length > 500);
    for (const message of messages) {
      assert.doesNotMatch(message, /\[object|; *is used|undefined is used/);
      assert.ok(message.length < 300, message);
    }
    claim(w, 'unknown-attribute');
    w.settings.set('nope', 1);
  },
);

// ---- a value equal to the last -------------------------------------------------------------------------------------

const unchanged = (w: World): unknown[] =>
  w.problems.filter(({ code }) => code === 'unchanged-value').map(({ attribute }) => attribute);

fact(
  'an equal value that the simulation has left behind is told once, with what acts instead',
  async () => {
    const w = await world();
    claim(w, 'unchanged-value');
    let heard = 0;
    w.on('problem', () => heard++);
    const spun = { position: [0, 5, 0], angularVelocity: [0, 0, 2], linearVelocity: [0, 0, 0] };
    const ball = w.add('RigidBody', { ...spun, orientation: [0, 0, 1, 0] }, { name: 'ball' });
    for (const [field, value] of Object.entries(spun)) ball.set(field, value);
    w.step(0);
    for (const [field, value] of Object.entries(spun)) ball.set(field, value);
    ball.set('orientation', [0, 1, 0, 0]);
    ball.set('orientation', [0, 0, 1, 0]);
    assert.equal(heard, 0, 'before it has moved');
    w.advance(0.5);
    const at = position(ball);
    for (let i = 0; i < 1000; i++) {
      ball.set('position', [0, 5, 0]);
      ball.set('orientation', [0, 0, 1, 0]);
      ball.set('linearVelocity', '0 0 0');
      ball.set('angularVelocity', [0, 0, 2]);
      ball.set('mass', 1);
    }
    assert.deepEqual(position(ball), at, 'and nothing is done');
    assert.deepEqual(unchanged(w), ['position', 'orientation', 'linearVelocity']);
    assert.equal(heard, 3);
    const [moves, , kicks] = w.problems;
    assert.equal(moves!.severity, 'info');
    assert.match(
      moves!.message,
      /RigidBody "ball": position="0 5 0" .* it is 0 3.775 0 by now; teleport\(\) moves it/,
    );
    assert.match(kicks!.message, /applyImpulse\(\) kicks it/);
    ball.set('position', [1, 5, 0]);
    w.step(0);
    assert.deepEqual(unchanged(w), ['orientation', 'linearVelocity'], 'a new value is an edit');
    w.advance(0.5);
    ball.set('position', [1, 5, 0]);
    assert.equal(heard, 3, 'its author knows');
  },
);

fact(
  'nothing is told of what stands where it was put, of velocities of what is fixed, or of edits that wait',
  async () => {
    const w = await world();
    addFloor(w);
    const fixed = addBody(w, { fixed: true, position: [5, 1, 0], linearVelocity: [1, 0, 0] });
    const lying = addBody(w, { position: [0, 0.5, 0], geometry: box(1) });
    const thrown = addBody(w, { position: [9, 9, 0] });
    w.advance(1);
    fixed.set('position', [5, 1, 0]);
    fixed.set('linearVelocity', [1, 0, 0]);
    lying.set('position', [0, 0.5, 0]);
    thrown.set('position', [9, 8, 0]);
    thrown.set('position', [9, 8, 0]);
    w.step(0);
    assert.deepEqual(w.problems, []);
  },
);

fact(
  'after a teleport the field still means what was last set: that is no edit, anything else is one',
  async () => {
    const w = await world(WEIGHTLESS);
    claim(w, 'unchanged-value');
    const ball = addBody(w, { position: [0, 5, 0] });
    w.step();
    ball.teleport([9, 0, 0]);
    ball.set('position', [0, 5, 0]);
    assert.deepEqual(position(ball), [9, 0, 0]);
    assert.deepEqual(unchanged(w), ['position']);
    ball.set('position', [1, 1, 1]);
    w.step(0);
    assert.deepEqual(position(ball), [1, 1, 1]);
    w.reset();
    assert.deepEqual(position(ball), [1, 1, 1], 'what was asked last');
  },
);

fact(
  'teleport takes velocities; what is left out stays, also about a centre of mass aside',
  async () => {
    for (const centerOfMass of [
      [0, 0, 0],
      [0.3, 0, 0],
    ]) {
      // prettier-ignore
      const w = await world(WEIGHTLESS);
      claim(w, 'bad-value');
      const ball = addBody(w, {
        linearVelocity: [1, 0, 0],
        angularVelocity: [0, 0, 2],
        centerOfMass,
      });
      w.step();
      const linear = velocity(ball);
      ball.teleport([0, 9, 0], [0, 1, 0, 1]);
      close(velocity(ball), linear, 1e-5, 'm/s, kept');
      close(spin(ball), [0, 0, 2], 1e-5, 'rad/s, kept');
      ball.teleport([0, 0, 0], undefined, { linearVelocity: [0, 3, 0] });
      close(ball.get('orientation') as number[], [0, 1, 0, 1], 1e-6, 'kept');
      close(velocity(ball), [0, 3, 0], 1e-5, 'm/s');
      close(spin(ball), [0, 0, 2], 1e-5, 'rad/s, kept');
      ball.sleep();
      ball.teleport([0, 0, 0], [0, 0, 1, 0], {
        linearVelocity: [2, 0, 0],
        angularVelocity: [0, 0, 0],
      });
      assert.equal(ball.sleeping, false);
      w.advance(1);
      close(position(ball), [2, 0, 0], 1e-4, 'm, with that velocity');
      const at = position(ball);
      ball.teleport([7, 7, 7], undefined, { linearVelocity: 'up' as never });
      ball.teleport([7, 7, 7], [1] as never);
      close(position(ball), at, 0, 'm, all or nothing');
    }
  },
);

fact('teleport puts a body back that had lost its numbers', async () => {
  const w = await world(WEIGHTLESS);
  claim(w, 'nan-state');
  const ball = addBody(w, { mass: 0.1 });
  ball.applyImpulse([1e38, 0, 0]);
  w.step(2);
  assert.equal(ball.parked, true);
  ball.teleport([1, 0, 0], undefined, { linearVelocity: [1, 0, 0] });
  w.advance(1);
  close(position(ball), [2, 0, 0], 1e-4, 'm');
  assert.deepEqual(w.problems, []);
});

// ---- problems of several nodes that stand for one element -----------------------------------------------------------

fact(
  'a problem stands while its cause does: new geometry and an equal value take nothing back',
  async () => {
    const w = await world();
    claim(w, 'out-of-range', 'zero-mass', 'bad-value');
    const host = { tag: 'an element' };
    const options = { host };
    const ball = w.add('RigidBody', { mass: -3, geometry: sphere(1) }, options);
    // Of the body's element, as in a page.
    const shape = w.add('CollidableShape', { shape: { type: 'Box', size: [1, 2] } }, options);
    const codes = (): string[] => w.problemsOf(host).map(({ code }) => code).sort(); // prettier-ignore
    assert.deepEqual(codes(), ['bad-value', 'out-of-range']);
    shape.remove();
    assert.deepEqual(codes(), ['out-of-range'], 'its own goes with it');
    ball.set('geometry', box(1));
    w.step();
    assert.deepEqual(codes(), ['out-of-range']);
    ball.set('mass', 0);
    w.step(0);
    ball.set('mass', 0);
    assert.deepEqual(codes(), ['zero-mass'], 'fixed as before');
    ball.set('mass', 'x');
    ball.set('mass', 0);
    assert.ok(!codes().includes('bad-value'));
    ball.set('mass', 2);
    w.step(0);
    assert.deepEqual(codes(), []);
  },
);
