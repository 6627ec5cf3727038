import assert from 'node:assert/strict';
import { debugLines, type World } from '../../physics-core/inside.js';
import {
  addBody,
  addFloor,
  addJoint,
  box,
  close,
  counts,
  fact,
  height,
  sphere,
  velocity,
  way,
  world,
} from './helpers.js';
import { leavesNoTrace } from './no-trace.js';

fact(
  'a thousand changes of shape, mass, mobility and joint leave no trace in the heap',
  async () => {
    const w = await world();
    addFloor(w);
    const stone = addBody(w, { position: [0, 2, 0], geometry: [box(1)] });
    const joint = addJoint(w, 'SingleAxisHingeJoint', { body1: stone });
    const mesh = {
      type: 'IndexedFaceSet',
      coord: [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1],
      coordIndex: [0, 2, 1, -1, 0, 1, 3, -1, 1, 2, 3, -1, 2, 0, 3, -1],
    };
    const change = (i: number) => {
      stone.set('geometry', [[box(1)], [sphere(0.4), box(2)], [mesh]][i % 3]);
      stone.set('centerOfMass', [0, (i % 5) / 10, 0]);
      stone.set('fixed', i % 2 === 0);
      joint.set('anchorPoint', [i % 7, 0, 0]);
      stone.set('enabled', i % 11 !== 0);
      w.step(i % 4);
    };
    await leavesNoTrace(w, () => {
      for (let i = 0; i < 1155; i++) change(i);
    });
  },
);

fact('resets and whole worlds come and go without a trace in the heap', async () => {
  const w = await world();
  const scene = (to: World) => {
    addFloor(to);
    for (let i = 0; i < 10; i++) addBody(to, { position: [0, 1 + i, 0], geometry: [box(1)] });
    to.add('CollisionCollection', { collidables: '*', bounce: 0.5 });
    to.step(10);
  };
  scene(w);
  const round = async () => {
    w.reset();
    w.step(10);
    const other = await world();
    scene(other);
    other.destroy();
  };
  await leavesNoTrace(w, async () => {
    for (let i = 0; i < 20; i++) await round();
  });
});

fact('what a node made of plain data goes with it', async () => {
  const w = await world();
  const before = [...w.nodes].length;
  const body = addBody(w, {
    geometry: [
      { type: 'CollidableOffset', collidable: { type: 'CollidableShape', shape: [box(1)] } },
    ],
  });
  w.step();
  assert.equal([...w.nodes].length, before + 3);
  body.set('geometry', [sphere(1)]);
  w.step();
  assert.equal([...w.nodes].length, before + 2);
  body.remove();
  assert.equal([...w.nodes].length, before);
  body.remove();
  assert.equal([...w.nodes].length, before);
});

fact(
  'a body that goes leaves its joint waiting, which holds the next body it is given (S29)',
  async () => {
    const w = await world();
    const [a, b] = [addBody(w), addBody(w, { position: [1, 0, 0] })];
    const joint = addJoint(w, 'BallJoint', { body1: a, body2: b });
    w.step();
    assert.equal(w.stats.joints, 1);
    a.remove();
    w.step();
    assert.equal(w.stats.joints, 0);
    const c = addBody(w, { position: [0, 0, 0], fixed: true });
    joint.set('body1', c);
    w.step(0);
    const gap = joint.gap;
    w.advance(1);
    assert.equal(w.stats.joints, 1);
    close(joint.gap, gap, 5e-3, 'm');
    joint.remove();
    b.event('linearVelocity', [0, 0, 0]);
    const at = height(b);
    w.advance(0.5);
    close(height(b), at - way(9.8, 0.5), 2e-3, 'm, let go');
  },
);

fact('a body on top of one that goes falls at once (S29)', async () => {
  const w = await world();
  const slab = addFloor(w);
  const stone = addBody(w, { position: [0, 0.5, 0], geometry: [box(1)] });
  w.advance(1);
  slab.remove();
  w.advance(0.5);
  close(height(stone), 0.5 - way(9.8, 0.5), 2e-3, 'm');
});

fact('a shape that grows in contact throws nothing out of its place (S30)', async () => {
  const w = await world();
  addFloor(w);
  const stone = addBody(w, { position: [0, 0.5, 0], geometry: [box(1)] });
  const top = addBody(w, { position: [0, 1.5, 0], geometry: [box(1)] });
  w.advance(1);
  stone.set('geometry', [box(1.2)]);
  let fastest = 0;
  for (let i = 0; i < 240; i++) {
    w.step();
    fastest = Math.max(fastest, ...[stone, top].map((body) => Math.hypot(...velocity(body))));
  }
  assert.ok(fastest < 1, `${fastest} m/s`);
  close([height(stone), height(top)], [0.6, 1.7], 5e-3, 'm');
});

fact('counts of made and unmade objects follow the nodes', async () => {
  const w = await world();
  const before = counts(w);
  const ball = addBody(w, { geometry: [] });
  const joint = addJoint(w, 'BallJoint', { body1: ball });
  assert.equal(counts(w).created, before.created + 2);
  joint.remove();
  ball.remove();
  assert.equal(counts(w).destroyed, before.destroyed + 2);
});

fact('the debug drawing of a hull gives back what it took', async () => {
  const w = await world();
  const coord = { point: [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1] };
  const tetrahedron = {
    type: 'IndexedTriangleSet',
    index: [0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3],
    coord,
  };
  addBody(w, { geometry: [tetrahedron] });
  w.step(0);
  await leavesNoTrace(w, async () => {
    for (let i = 0; i < 100; i++) {
      const lines = await debugLines(w);
      lines.update();
      lines.dispose();
    }
  });
});
