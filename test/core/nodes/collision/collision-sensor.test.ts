import assert from 'node:assert/strict';
import { addBody, box, fact, world, type Node } from '../../helpers.js';
import { watched } from './watched.js';

fact(
  'a pair counts only if both members are in the collection, and disabled it sends nothing',
  async () => {
    const { w, shapes, collection, sensor } = await watched(2);
    const sent: string[] = [];
    for (const name of ['isActive', 'intersections', 'contacts'])
      sensor.on(name, (value) => sent.push(`${name} ${String(value && (value as []).length)}`));
    w.step();
    assert.equal((sensor.get('intersections') as unknown[]).length, 3);
    collection.set('collidables', shapes);
    w.step();
    assert.deepEqual(sent.slice(-3), ['intersections 0', 'contacts 0', 'isActive false']);
    collection.set('collidables', '*');
    w.step();
    const before = sent.length;
    sensor.set('enabled', false);
    w.step(3);
    assert.equal(sent.length, before);
    assert.equal(sensor.get('isActive'), false);
  },
);

fact('in a compound body it is the part that touches', async () => {
  const w = await world();
  const slab = w.add('CollidableShape', { shape: [box(60, 1, 60)] });
  const [low, high] = [0, 1].map(() => w.add('CollidableShape', { shape: [box(1)] }));
  const at = (y: number, collidable: unknown) => ({
    type: 'CollidableOffset',
    translation: [0, y, 0],
    collidable,
  });
  addBody(w, { fixed: true, position: [0, -0.5, 0], geometry: [slab] });
  addBody(w, { position: [0, 0.5, 0], geometry: [at(0, low), at(1, high)] });
  const collection = w.add('CollisionCollection', { collidables: '*' });
  const sensor = w.add('CollisionSensor', { collider: collection });
  w.advance(0.5);
  const touching = sensor.get('intersections') as Node[];
  assert.deepEqual([touching.includes(low!), touching.includes(high!)], [true, false]);
});
