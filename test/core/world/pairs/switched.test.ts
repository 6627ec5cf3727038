import {
  addBody,
  addFloor,
  box,
  close,
  fact,
  height,
  position,
  way,
  world,
  type Body,
  type Node,
} from '../../helpers.js';
import type { World } from '../../../../physics-core/inside.js';

// A collection that is switched on and off between bodies that both move, and are in the same collections.

const shapeOf = (w: World, geometry: object = box(1)): Node =>
  w.add('CollidableShape', { shape: [geometry] });

/** A box on another one on a floor. */
async function stacked(others = 0) {
  const w = await world();
  // So many kinds of bodies that Bullet has no bits left for these.
  for (let i = 0; i < others; i++) {
    const shape = shapeOf(w);
    addBody(w, { position: [20 + 3 * i, 50, 0], useGlobalGravity: false, geometry: [shape] });
    w.add('CollisionCollection', { collidables: [shape] });
  }
  const shapes = [shapeOf(w), shapeOf(w)];
  const boxes = shapes.map((shape, i) =>
    addBody(w, { position: [0, 0.5 + i, 0], geometry: [shape] }),
  );
  addFloor(w);
  const collection = w.add('CollisionCollection', { collidables: shapes });
  return { w, collection, lower: boxes[0]!, upper: boxes[1]! };
}

for (const others of [0, 20]) {
  const where = others ? `, after ${others} other collections` : '';

  fact(
    `a box sinks into the one that it stands on when their collection is disabled${where}`,
    async () => {
      const { w, collection, lower, upper } = await stacked(others);
      w.advance(0.5);
      close(height(upper), 1.5, 1e-3, 'm, on it');
      collection.set('enabled', false);
      w.advance(0.25);
      close(height(upper), 1.5 - way(9.8, 0.25), 2e-3, 'm, in it');
      w.advance(0.5);
      close([height(lower), height(upper)], [0.5, 0.5], 1e-3, 'm, both on the floor');
    },
  );

  fact(
    `two boxes come together in a disabled collection and part when it is enabled${where}`,
    async () => {
      const { w, collection, lower, upper } = await stacked(others);
      collection.set('enabled', false);
      upper.event('position', [0.3, 0.5, 0]);
      w.advance(0.5);
      close(position(upper)[0] - position(lower)[0], 0.3, 1e-3, 'm');
      collection.set('enabled', true);
      w.advance(1);
      close(Math.abs(position(upper)[0] - position(lower)[0]), 1, 0.02, 'm');
    },
  );
}

fact(
  'of two compounds alike only the parts of a disabled collection pass through each other',
  async () => {
    const w = await world({ gravity: [0, 0, 0] });
    const parts = Array.from({ length: 4 }, () => shapeOf(w));
    const at = (x: number, collidable: Node) => ({
      type: 'CollidableOffset',
      translation: [x, 0, 0],
      collidable,
    });
    const [left, right] = [
      addBody(w, { geometry: [at(0, parts[0]!), at(-4, parts[1]!)] }),
      addBody(w, { position: [0.6, 0, 0], geometry: [at(0, parts[2]!), at(4, parts[3]!)] }),
    ] as [Body, Body];
    const inner = w.add('CollisionCollection', { collidables: [parts[0], parts[2]] });
    w.add('CollisionCollection', { collidables: [parts[1], parts[3]] });
    inner.set('enabled', false);
    w.advance(0.5);
    close(position(right)[0] - position(left)[0], 0.6, 1e-4, 'm');
    inner.set('enabled', true);
    w.advance(0.5);
    close(position(right)[0] - position(left)[0], 1, 0.02, 'm');
  },
);
