import assert from 'node:assert/strict';
import { createWorld } from '../../../../physics-core/create.js';
import {
  addBody,
  addFloor,
  addJoint,
  box,
  claim,
  close,
  fact,
  height,
  sphere,
  watch,
  way,
  world,
  told,
} from '../../helpers.js';

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
