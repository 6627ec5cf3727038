import assert from 'node:assert/strict';
import { addBody, box, close, fact, height, velocity, world, type Node } from '../../helpers.js';
import { shapeOf } from './scenes.js';

const offset = (x: number, collidable: Node) => ({
  type: 'CollidableOffset',
  translation: [x, 0, 0],
  collidable,
});

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
