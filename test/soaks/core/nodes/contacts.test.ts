import assert from 'node:assert/strict';
import { close, fact, position } from '../../../core/helpers.js';
import { watched } from '../../../core/nodes/collision/watched.js';

fact('thousands of steps of contacts leave nothing behind', async () => {
  const { w, sensor, stones } = await watched(10);
  let most = 0;
  sensor.on('contacts', (contacts) => {
    most = Math.max(most, (contacts as unknown[]).length);
    w.settings.event('set_contacts', contacts);
  });
  w.advance(1);
  const probe = w.add('CollidableShape');
  w.step();
  const before = { nodes: [...w.nodes].length, heap: w.stats.heapBytes, made: w.stats.created };
  w.step(3000);
  assert.equal(most, 40);
  assert.deepEqual(
    { nodes: [...w.nodes].length, heap: w.stats.heapBytes, made: w.stats.created },
    before,
  );
  assert.equal(w.add('CollidableShape').id, probe.id + 1);
  stones.forEach((stone, i) => close(position(stone), [2 * i, 0.5, 0], 2e-3, 'm'));
});
