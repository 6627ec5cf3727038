import { addBody, box, world, type Sensor } from '../../helpers.js';

export async function watched(count: number) {
  const w = await world();
  const slab = w.add('CollidableShape', { shape: [box(60, 1, 60)] });
  const shapes = Array.from({ length: count }, () => w.add('CollidableShape', { shape: [box(1)] }));
  addBody(w, { fixed: true, position: [0, -0.5, 0], geometry: [slab] });
  const stones = shapes.map((shape, i) =>
    addBody(w, { position: [2 * i, 0.5, 0], geometry: [shape] }),
  );
  const collection = w.add('CollisionCollection', { collidables: [slab, ...shapes] });
  const sensor = w.add('CollisionSensor', { collider: collection }) as Sensor;
  return { w, slab, shapes, stones, collection, sensor };
}
