import assert from 'node:assert/strict';
import type { World } from '../../../../physics-core/inside.js';
import type { CollectionNode } from '../../../../physics-core/nodes/collection-node.js';
import {
  addBody,
  box,
  close,
  fact,
  height,
  sphere,
  velocity,
  way,
  world,
  type Body,
  type Node,
} from '../../helpers.js';

// What is known of the parts of two bodies, which Bullet numbers, and of the triangles of meshes, which it numbers too.

const G = 9.81;

const shapeOf = (w: World, geometry: object = sphere(0.5)): Node =>
  w.add('CollidableShape', { shape: [geometry] });

const offset = (x: number, collidable: Node) => ({
  translation: [x, 0, 0],
  collidable,
});

/** A square of two triangles, 8 m wide, around x. */
const square = (x: number) => ({
  type: 'IndexedTriangleSet',
  coord: [x - 4, 0, -4, x + 4, 0, -4, x + 4, 0, 4, x - 4, 0, 4],
  index: [0, 2, 1, 0, 3, 2],
});

/** Drops the ball from 1 m above x and tells how high it comes back, by its energy. */
function rebound(w: World, ball: Body, x: number): number {
  ball.event('position', [x, 1.5, 0]);
  ball.event('linearVelocity', [0, 0, 0]);
  w.advance(0.6);
  return height(ball) - 0.5 + velocity(ball)[1] ** 2 / (2 * G);
}

fact('each mesh of a body bounces as its own collection says', async () => {
  const w = await world({ gravity: [0, -G, 0] });
  const meshes = [-5, 5].map((x) => shapeOf(w, square(x)));
  addBody(w, { fixed: true, geometry: meshes });
  const shape = shapeOf(w);
  const ball = addBody(w, { position: [0, 9, 0], geometry: [shape] });
  meshes.forEach((mesh, i) =>
    w.add('CollisionCollection', {
      collidables: [mesh, shape],
      bounce: [0.5, 0.8][i],
      minBounceSpeed: 0,
    }),
  );
  // Each on either triangle.
  for (const [x, bounce] of [
    [-7, 0.5],
    [3, 0.8],
    [-3, 0.5],
    [7, 0.8],
  ] as const)
    close(rebound(w, ball, x), bounce ** 2, 1e-3, `m, at ${x}`);
});

fact('parts that change places keep who they meet', async () => {
  const w = await world({ gravity: [0, -G, 0] });
  const [meeting, passing, shape] = [
    shapeOf(w, box(2, 1, 2)),
    shapeOf(w, box(2, 1, 2)),
    shapeOf(w),
  ];
  w.add('CollisionCollection', { collidables: [meeting, shape] });
  w.add('CollisionCollection', { collidables: [passing, shape], enabled: false });
  const [left, right] = [
    w.add('CollidableOffset', offset(-3, meeting)),
    w.add('CollidableOffset', offset(3, passing)),
  ];
  const floor = addBody(w, { fixed: true, position: [0, -0.5, 0], geometry: [left, right] });
  const ball = addBody(w, { position: [-3, 0.5, 0], geometry: [shape] });
  w.advance(0.2);
  close(height(ball), 0.5, 1e-3, 'm, on the left one');
  floor.set('geometry', [right, left]);
  w.advance(0.2);
  close(height(ball), 0.5, 1e-3, 'm, still on it');
  ball.event('position', [3, 0.5, 0]);
  w.advance(0.2);
  close(height(ball), 0.5 - way(9.81, 0.2), 2e-3, 'm, falling through the right one');
});

fact('a body that goes over to another collection meets what its new collider says', async () => {
  const w = await world({ gravity: [0, -G, 0] });
  const slabs = [shapeOf(w, box(2, 1, 2)), shapeOf(w, box(2, 1, 2))] as const;
  const shapes = [shapeOf(w), shapeOf(w), shapeOf(w)] as const;
  const [here, there] = slabs.map((slab) =>
    w.add('RigidBodyCollection', {
      gravity: [0, -G, 0],
      autoDisable: false,
      collider: w.add('CollisionCollection', { collidables: [slab, ...shapes] }),
    }),
  ) as [CollectionNode, CollectionNode];
  addBody(w, {
    fixed: true,
    position: [0, -0.5, 0],
    geometry: slabs.map((slab, i) => w.add('CollidableOffset', offset(6 * i - 3, slab))),
  });
  const [, , ball] = shapes.map((shape, i) =>
    w.add(
      'RigidBody',
      { position: [[9, 15, -3][i], 0.5, 0], geometry: [shape] },
      { collection: i === 1 ? there : here },
    ),
  ) as [Body, Body, Body];
  w.advance(0.2);
  close(height(ball), 0.5, 1e-3, 'm, on the left slab');
  ball.belongTo(there);
  w.advance(0.2);
  close(height(ball), 0.5 - way(G, 0.2), 2e-3, 'm, through it');
});

fact('a shape is looked through once, however many of its contacts are asked for', async () => {
  const w = await world({ gravity: [0, -G, 0] });
  let looks = 0;
  const watched = (x: number) => {
    const { index, ...mesh } = square(x);
    return Object.defineProperty(mesh, 'index', { enumerable: true, get: () => (looks++, index) });
  };
  const meshes = [-4, 4].map((x) => shapeOf(w, watched(x)));
  addBody(w, { fixed: true, geometry: meshes });
  const shape = shapeOf(w, box(1));
  const stone = addBody(w, { position: [-1, 0.5, 0], geometry: [shape] });
  const collider = w.add('CollisionCollection', { collidables: [...meshes, shape] });
  const sensor = w.add('CollisionSensor', { collider });
  w.step(2);
  assert.equal(sensor.get('isActive'), true);
  const before = looks;
  w.step(20);
  assert.equal(looks, before);
  close(height(stone), 0.5, 1e-3, 'm');
  // The meshes change places: they are looked through anew, and the stone stands on the other one.
  const under = () => (sensor.get('intersections') as Node[]).filter((one) => one !== shape);
  assert.deepEqual(under(), [meshes[0]]);
  meshes.forEach((mesh, i) => mesh.set('shape', [square([5, -4][i]!)]));
  w.step(2);
  assert.deepEqual(under(), [meshes[1]]);
});
