import assert from 'node:assert/strict';
import type { SoftNode } from '../../../../physics-core/nodes/soft/soft-node.js';
import { below, WEIGHTLESS, world } from '../../helpers.js';
import type { Row } from './row.js';

/** Of a rope, a cloth or a soft body at the origin. */
export const softDragRow = (type: string, fields: Record<string, unknown>): Row => ({
  field: 'draggableBody',
  fact: 'tells the page what may be dragged, by its own word or its collection’s, and no more takes the hand off',
  run: async () => {
    const w = await world(WEIGHTLESS);
    const node = w.add(type, fields) as SoftNode;
    const told: boolean[] = [];
    w.on('draggable', () => told.push(node.offered));
    w.step(0);
    node.set('draggableBody', true);
    w.step(0);
    assert.deepEqual(told, [true]);
    const drag = node.drag([0, 0, 0])!;
    drag.move([1, 0, 0]);
    w.step(2);
    node.set('draggableBody', false);
    w.step(0);
    assert.deepEqual(told, [true, false]);
    assert.equal(drag.held, false);
    below(drag.point[0], 0.5, 'let go on its way, at');
    node.unset('draggableBody');
    w.set('draggableBody', true);
    w.step(0);
    assert.deepEqual(told, [true, false, true]);
    node.remove();
    w.step(0);
    assert.deepEqual(told, [true, false, true, false]);
  },
});
