import assert from 'node:assert/strict';
import {
  addBody,
  addJoint,
  box,
  claim,
  fact,
  sphere,
  world,
  type Node,
  codes,
  told,
} from '../../helpers.js';
import { only } from '../problems.js';

/** X3D text, arrays and other things that are no value of their type. */
const MALFORMED: [type: string, field: string, values: unknown[]][] = [
  ['RigidBody', 'mass', ['heavy', '', '1 2', NaN, Infinity, [1], null, {}, true]],
  ['RigidBody', 'position', ['1 2', '1 2 3 4', 'a b c', [1, 2], [1, NaN, 3], 5, null]],
  ['RigidBody', 'orientation', ['0 1 0', [0, 1, 0], [0, 1, 0, 'x']]],
  ['RigidBody', 'inertia', ['1 0 0', [1, 2, 3]]],
  ['RigidBody', 'forces', ['1 2', [[1, 2]], [[1, 2, NaN]]]],
  ['RigidBody', 'fixed', ['maybe', 1, null]],
  ['CollisionCollection', 'frictionCoefficients', ['1', [1, 2, 3]]],
  ['CollisionCollection', 'appliedParameters', [5, [1, 2]]],
  ['RigidBodyCollection', 'iterations', ['1.5', 2.5, 'many']],
  ['RigidBodyCollection', 'accuracy', ['best', 7]],
];

fact('a malformed value keeps the last valid one and is reported with what is used', async () => {
  for (const [type, field, values] of MALFORMED) {
    const w = await world();
    const node = w.add(type, {});
    const before = node.get(field);
    for (const value of values) {
      node.set(field, value);
      assert.deepEqual(node.get(field), before, `${field} after ${String(value)}`);
      const problem = only(w, 'bad-value');
      assert.equal(problem.element, node);
      assert.equal(problem.attribute, field);
      assert.deepEqual(problem.used, before);
    }
    node.event(field, before);
    assert.deepEqual(codes(w), [], 'a valid value settles it');
  }
});

fact(
  'out of a closed range clamps to it, out of an open one keeps the last valid value',
  async () => {
    const w = await world();
    const [ball, hinge, collection] = [
      addBody(w, { mass: 3 }),
      w.add('SingleAxisHingeJoint', { body1: addBody(w) }),
      w.add('CollisionCollection', { frictionCoefficients: [1, 2] }),
    ];
    const cases: [Node, string, unknown, unknown][] = [
      [ball, 'mass', -1, 3],
      [ball, 'linearDampingFactor', 5, 1],
      [ball, 'linearDampingFactor', -5, 0],
      [ball, 'disableTime', -1, 0],
      [hinge, 'minAngle', -9, -Math.PI],
      [hinge, 'stopBounce', 1.5, 1],
      [collection, 'bounce', '2', 1],
      [collection, 'frictionCoefficients', [-1, 1], [1, 2]],
      [w.settings, 'errorCorrection', 7, 1],
      [w.settings, 'iterations', -1, 10],
      [w.settings, 'heapLimit', 1, 16],
    ];
    for (const [node, field, value, used] of cases) {
      node.set(field, value);
      assert.deepEqual(node.get(field), used, field);
      const problem = only(w, 'out-of-range');
      assert.deepEqual([problem.attribute, problem.used], [field, used]);
      w.settle(node);
    }
  },
);

fact('a problem is told once until it changes, and taken back when it is mended', async () => {
  const w = await world();
  claim(w, 'bad-value');
  const told: string[] = [];
  w.on('problem', (problem) => told.push((problem as { message: string }).message));
  const ball = addBody(w, { name: 'b' } as never);
  w.settle(ball);
  claim(w, 'unknown-attribute');
  told.length = 0;
  ball.set('mass', 'heavy');
  ball.set('mass', 'heavy');
  assert.equal(told.length, 1);
  ball.set('mass', 'light');
  assert.equal(told.length, 2);
  assert.match(told[1]!, /mass="light".*SFFloat.*1 is used/);
  ball.set('mass', 2);
  assert.deepEqual(w.problemsOf(ball), []);
  ball.set('mass', 'light');
  assert.equal(told.length, 3);
  ball.remove();
  assert.deepEqual(w.problems, []);
});

fact('a list that is too short is told how many numbers it takes', async () => {
  const w = await world();
  const [collection, ball] = [w.add('CollisionCollection'), addBody(w)];
  collection.set('frictionCoefficients', '0');
  assert.match(
    only(w, 'bad-value').message,
    /frictionCoefficients="0" is not SFVec2f: 2 numbers; it counts as not written$/,
  );
  collection.set('frictionCoefficients', '0 0');
  collection.set('frictionCoefficients', '1');
  assert.match(only(w, 'bad-value').message, /2 numbers; 0 0 is used$/);
  collection.remove();
  ball.set('orientation', '0 1 0');
  assert.match(
    only(w, 'bad-value').message,
    /SFRotation: 4 numbers, axis and angle in radians; 0 0 1 0 is used$/,
  );
});

fact('an angle out of its range is told to be in radians, other numbers are not', async () => {
  const w = await world();
  const hinge = w.add('SingleAxisHingeJoint', { body1: addBody(w), minAngle: -90 });
  assert.match(only(w, 'out-of-range').message, /minAngle="-90" is outside \[.*\] radians; -3.14/);
  hinge.remove();
  const ball = addBody(w, { linearDampingFactor: 5 });
  assert.match(only(w, 'out-of-range').message, /is outside \[0, 1\]; 1 is used/);
  ball.remove();
});

fact('everyday words for a field are told which it is, and which node has it', async () => {
  const w = await world();
  claim(w, 'unknown-attribute');
  const [ball, hinge] = [addBody(w), w.add('SingleAxisHingeJoint', { body1: addBody(w) })];
  const list = w.add('CollisionCollection');
  const motor = w.add('MotorJoint', { body1: ball });
  for (const [node, word, answer] of [
    [ball, 'weight', '; did you mean mass?'],
    [ball, 'Static', '; write fixed="true": nothing moves it, and what hits it bounces off'],
    [ball, 'gravity-scale', /; write useGlobalGravity="false" .*: X3D knows no share of gravity/],
    [ball, 'damping', /; write linearDampingFactor=/],
    [ball, 'kinematic', /; write fixed="true": a fixed body that is moved, .* is carried/],
    [list, 'kinematic', /; RigidBody has fixed: a fixed body that is moved/],
    [ball, 'ccd', '; fast bodies do not tunnel here: leave it out'],
    [ball, 'velocity', '; did you mean linearVelocity?'],
    [ball, 'torque', '; did you mean torques?'],
    [ball, 'friction', '; CollisionCollection has frictionCoefficients'],
    [ball, 'restitution', '; CollisionCollection has bounce'],
    [ball, 'gravity', '; RigidBodyCollection has gravity'],
    [list, 'friction', '; did you mean frictionCoefficients?'],
    [list, 'restitution', '; did you mean bounce?'],
    [hinge, 'torque', '; MotorJoint has axis1Torque'],
    [hinge, 'anchor', '; did you mean anchorPoint?'],
    [ball, 'bounce', '; CollisionCollection has bounce'],
    [motor, 'axis', '; did you mean motor1Axis?'],
    [hinge, 'min', /; stops are minAngle and maxAngle of a hinge, minSeparation/],
    [ball, 'mas', '; did you mean mass?'],
    [ball, 'constructor', ''],
    [ball, 'colour', ''],
  ] as const) {
    node.set(word, 1);
    const [message] = told(w, 'unknown-attribute');
    if (typeof answer === 'string')
      assert.ok(message!.endsWith(`has no field ${word}${answer}`), message);
    else assert.match(message!, answer);
    w.settle(node);
  }
});

fact(
  'an unknown field, an output that is set and an event to an initializeOnly field are told',
  async () => {
    const w = await world();
    const ball = addBody(w);
    ball.set('weight', 5);
    assert.equal(only(w, 'unknown-attribute').attribute, 'weight');
    assert.equal(ball.get('weight'), undefined);
    w.settle(ball);
    const hinge = addJoint(w, 'SingleAxisHingeJoint', { body1: ball });
    hinge.set('angle', 1);
    assert.equal(only(w, 'bad-access').attribute, 'angle');
    w.settle(hinge);
    const shape = w.add('CollidableShape', { shape: [box(1)] });
    const list = shape.get('shape');
    shape.event('shape', [sphere(1)]);
    assert.equal(only(w, 'bad-access').attribute, 'shape');
    assert.deepEqual(shape.get('shape'), list);
  },
);

fact('an unknown node type throws: it is a mistake of a program, not of an author', async () => {
  const w = await world();
  assert.throws(() => w.add('RigidBoddy'), /no node type RigidBoddy/);
});
