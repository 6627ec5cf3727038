import assert from 'node:assert/strict';
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
  velocity,
  way,
  world,
  codes,
  overflow,
} from '../../helpers.js';
import { only } from '../problems.js';

fact('geometry where no geometry belongs is told and left out', async () => {
  const w = await world();
  const ball = addBody(w, { geometry: [{ type: 'BallJoint' }, sphere(0.5)] });
  assert.equal(only(w, 'misplaced').value, 'BallJoint');
  w.step();
  assert.equal(ball.parts.length, 1);
});

fact('mass 0 is told, makes the body fixed, and ends when it gets a mass', async () => {
  const w = await world();
  const ball = addBody(w, { mass: 0 });
  w.advance(0.5);
  close(height(ball), 0, 0, 'm');
  assert.equal(only(w, 'zero-mass').severity, 'info');
  ball.set('mass', 1);
  w.advance(0.5);
  close(height(ball), -way(9.8, 0.5), 1e-3, 'm');
  assert.deepEqual(codes(w), []);
});

fact('a hollow mesh that moves is told, and no longer when it is fixed', async () => {
  const w = await world();
  // Two triangles with an edge in common, bent like an open book.
  const book = {
    type: 'IndexedFaceSet',
    coord: [-1, 1, -1, 0, 0, -1, 1, 1, -1, -1, 1, 1, 0, 0, 1, 1, 1, 1],
    coordIndex: [0, 3, 4, 1, -1, 1, 4, 5, 2, -1],
  };
  const body = addBody(w, { geometry: [book] });
  w.step();
  assert.equal(only(w, 'concave-dynamic').used, 'convex hull');
  body.set('fixed', true);
  w.step();
  assert.deepEqual(codes(w), []);
});

fact('geometry without volume, points or faces is told and stays finite (S13)', async () => {
  for (const geometry of [
    box(1, 0, 1),
    box(1, -1, 1),
    sphere(0),
    { type: 'Cylinder', radius: 0, height: 1 },
    { type: 'Cone', bottomRadius: 1, height: 0 },
    { type: 'IndexedFaceSet' },
    { type: 'IndexedFaceSet', coord: [0, 0, 0], coordIndex: [0, 1, 2, -1] },
    { type: 'TriangleSet', coord: [] },
    { type: 'ElevationGrid', xDimension: 1, zDimension: 1, height: [0] },
  ]) {
    const w = await world();
    addFloor(w);
    const body = addBody(w, { position: [0, 2, 0], geometry: [geometry] });
    w.advance(1);
    only(w, 'zero-volume');
    assert.ok(velocity(body).every(Number.isFinite), geometry.type);
  }
});

fact(
  'a collidable belongs to the first body that names it and goes to the second when it is free',
  async () => {
    const w = await world();
    addFloor(w);
    const shape = w.add('CollidableShape', { shape: [box(1)] });
    const first = addBody(w, { position: [0, 0.5, 0], geometry: [shape] });
    const second = addBody(w, { position: [3, 0.5, 0], geometry: [shape] });
    w.advance(0.5);
    const problem = only(w, 'already-owned');
    assert.equal(problem.element, second);
    close([height(first), height(second)], [0.5, 0.5 - way(9.8, 0.5)], 2e-3, 'm');
    first.remove();
    w.step(0);
    assert.deepEqual(codes(w), []);
    second.teleport([0, 3, 0]);
    second.event('linearVelocity', [0, 0, 0]);
    w.advance(2);
    close(height(second), 0.5, 2e-3, 'm, it has the shape now');
  },
);

fact('a body that is in no list of the collider is told', async () => {
  const w = await world();
  const shape = w.add('CollidableShape', { shape: [box(1)] });
  addBody(w, { geometry: [shape] });
  const outside = addBody(w);
  const collider = w.add('CollisionCollection', { collidables: [shape] });
  w.set('collider', collider);
  w.step();
  const problem = only(w, 'not-in-collider');
  assert.deepEqual([problem.element, problem.severity], [outside, 'info']);
  collider.set('collidables', '*');
  w.step();
  assert.deepEqual(codes(w), []);
});

fact('a body that lost its numbers goes on from where its author puts it', async () => {
  const w = await world();
  const ball = addBody(w, { mass: 0.1 });
  // 1e39 m/s: infinite in single precision.
  overflow(ball, [1e38, 0, 0]);
  w.step(2);
  assert.equal(only(w, 'nan-state').severity, 'error');
  close(ball.get('position') as number[], [0, 0, 0], 0, 'm, last good pose');
  ball.set('position', [0, 4, 0]);
  ball.set('linearVelocity', [0, 0, 0]);
  w.advance(0.5);
  close(height(ball), 4 - way(9.8, 0.5), 1e-3, 'm');
  assert.deepEqual(codes(w), []);
});

fact('a chain goes on when one of its links loses its numbers (S25)', async () => {
  const w = await world();
  claim(w, 'nan-state');
  const links = Array.from({ length: 6 }, (_, i) =>
    addBody(w, { position: [i, 0, 0], geometry: [sphere(0.2)] }),
  );
  links.forEach((link, i) =>
    addJoint(w, 'BallJoint', {
      body1: links[i - 1] ?? null,
      body2: link,
      anchorPoint: [i - 1, 0, 0],
    }),
  );
  w.advance(0.5);
  links[3]!.set('mass', 0.1);
  overflow(links[3]!, [0, 1e38, 0]);
  w.step(2);
  assert.deepEqual(
    links.map((link) => w.problemsOf(link).length),
    [0, 0, 0, 1, 0, 0],
  );
  w.advance(2);
  for (const link of links) assert.ok(velocity(link).every(Number.isFinite));
  assert.ok(height(links[5]!) < -10, 'the rest below it fell off');
  assert.ok(height(links[2]!) > -3.1, 'the rest above it hangs on');
});

fact('bodies that begin inside each other are told of once, walls that cross are not', async () => {
  const w = await world({ gravity: [0, 0, 0] });
  claim(w, 'initial-overlap');
  addBody(w, { fixed: true, geometry: [box(2)] });
  addBody(w, { fixed: true, position: [1, 0, 0], geometry: [box(2)] });
  addBody(w, { position: [10, 0, 0], geometry: [box(1)] });
  addBody(w, { position: [10.5, 0, 0], geometry: [box(1)] });
  w.step(3);
  const told = w.problems.filter(({ code }) => code === 'initial-overlap');
  assert.equal(told.length, 1);
  assert.ok(Math.abs((told[0]!.value as number) - 0.5) < 0.01);
});

fact("methods of a body refuse what can't be read as finite numbers, and take text", async () => {
  const w = await world({ gravity: [0, 0, 0] });
  claim(w, 'bad-value');
  const ball = addBody(w);
  w.step();
  for (const bad of [undefined, null, 'up', [1], [1, NaN, 0], 7] as never[]) {
    ball.applyForce(bad);
    ball.applyTorque(bad);
    ball.applyImpulse(bad);
    ball.teleport(bad);
  }
  w.step(10);
  assert.deepEqual(ball.get('position'), [0, 0, 0]);
  ball.teleport('1 2 3' as never);
  assert.deepEqual(ball.get('position'), [1, 2, 3]);
});
