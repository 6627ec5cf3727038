import assert from 'node:assert/strict';
import { addBody, box, fact, world } from '../../helpers.js';

fact(
  'what a carried body touches is looked for and woken once in a step, however much is told of it',
  async () => {
    const w = await world({ rest: 'auto' });
    const plate = addBody(w, { fixed: true, geometry: [box(4, 0.2, 4)] });
    const crate = addBody(w, { position: [0, 0.6, 0], geometry: [box(1, 1, 1)] });
    w.step(600);
    assert.ok(crate.sleeping, 'it has come to rest');
    const { bullet } = w;
    let searches = 0;
    const each = bullet.eachTouching.bind(bullet);
    bullet.eachTouching = (body, visit) => {
      if (body === plate.pointer) searches++;
      each(body, visit);
    };
    for (let i = 1; i <= 3; i++) {
      plate.set('position', [0.001 * i, 0, 0]);
      plate.set('orientation', [0, 1, 0, 0.001 * i]);
      w.step();
      assert.equal(searches, i);
      assert.ok(!crate.sleeping, 'it goes along, awake');
    }
  },
);
