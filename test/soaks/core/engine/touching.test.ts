import assert from 'node:assert/strict';
import { addBody, addFloor, box, fact, world } from '../../../core/helpers.js';

fact('who rested on a fixed body that jumps wakes, and nobody else is asked', async () => {
  for (const count of [10, 100]) {
    const w = await world({ rest: 'auto' });
    addFloor(w, 0, { geometry: [box(500, 1, 60)] });
    const lay = (x: number, y: number) =>
      addBody(w, { position: [x, y, 0], geometry: [box(1, 1, 1)] });
    for (let i = 0; i < count; i++) lay(3 + 2 * i, 0.5);
    const stone = addBody(w, { fixed: true, position: [0, 0.5, 0], geometry: [box(1, 1, 1)] });
    const upon = lay(0, 1.5);
    w.advance(3);
    assert.equal(w.stats.awake, 0);
    let asked = 0;
    w.bullet.eachPair = () => asked++;
    stone.teleport([0, 0.5, 5]);
    assert.equal(upon.sleeping, false);
    assert.equal(asked, 0);
    Reflect.deleteProperty(w.bullet, 'eachPair');
    assert.equal(w.stats.awake, 1);
  }
});
