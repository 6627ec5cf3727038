import assert from 'node:assert/strict';
import type { World } from '../../../../../physics-core/inside.js';
import {
  above,
  addBody,
  addJoint,
  below,
  close,
  position,
  velocity,
  world,
} from '../../../helpers.js';
import type { Body } from '../../../helpers.js';
import type { Row } from '../row.js';

/** Without gravity, a body at the origin that somebody draws 1 m to the right. */
async function drawn(fields: Record<string, unknown>, of: Record<string, unknown> = {}) {
  const w = await world({ gravity: [0, 0, 0], ...of });
  const body = addBody(w, fields);
  const drag = body.drag([0, 0, 0])!;
  drag.move([1, 0, 0]);
  return { w, body, drag };
}

/** Edits a field of a body, or of its collection. */
type Edit = (w: World, body: Body, value: unknown) => void;
const ofBody =
  (field: string): Edit =>
  (_, body, value) =>
    body.set(field, value);
const ofCollection =
  (field: string): Edit =>
  (w, _, value) =>
    w.set(field, value);

const draggable = (edit: Edit): Row => ({
  field: 'draggableBody',
  fact: 'tells the page who may be dragged, and no more takes the hand off',
  run: async () => {
    const { w, body } = await drawn({});
    const told: boolean[] = [];
    w.on('draggable', () => told.push(body.draggable));
    edit(w, body, true);
    w.step(2);
    assert.deepEqual(told, [true]);
    edit(w, body, false);
    w.step(60);
    assert.deepEqual(told, [true, false]);
    below(position(body)[0], 0.9, 'let go on its way, at');
  },
});

const mode = (edit: Edit): Row => ({
  field: 'dragMode',
  fact: 'goes on in the new mode while a body is held',
  run: async () => {
    const { w, body, drag } = await drawn({});
    w.step(4);
    below(position(body)[0], 0.2, 'drawn by a spring to');
    edit(w, body, 'teleport');
    w.step(0);
    const [x] = position(body);
    w.step(30);
    close(position(body)[0], x, 1e-6, 'held where it was on its way');
    drag.move([1, 0, 0]);
    close(position(body), [1, 0, 0], 1e-6, 'set down at');
    edit(w, body, 'spring');
    w.step(0);
    drag.move([2, 0, 0]);
    close(position(body), [1, 0, 0], 1e-6, 'a spring takes time, at');
    w.step(120);
    close(position(body), [2, 0, 0], 0.001, 'drawn to');
  },
});

export const bodyDragRows: Row[] = [
  draggable(ofBody('draggableBody')),
  mode(ofBody('dragMode')),
  {
    effect: 'dragging',
    fact: 'draws a body to where the hand is, against gravity',
    run: async () => {
      const { w, body } = await drawn({}, { gravity: [0, -9.8, 0] });
      w.step(240);
      // It hangs lower by g / 30².
      close(position(body), [1, -9.8 / 900, 0], 1e-4, 'held at');
    },
  },
  {
    effect: 'dragging',
    fact: 'works through the joint solve where joints hold the body',
    run: async () => {
      const w = await world();
      const bob = addBody(w, { position: [0, -1, 0] });
      const joint = addJoint(w, 'BallJoint', { body2: bob, anchorPoint: [0, 0, 0] });
      bob.drag([0, -1, 0])!.move([2, 0, 0]);
      w.step(360);
      above(position(bob)[0], 0.99, 'held aside at');
      below(joint.gap, 1e-5, 'gap');
      below(Math.hypot(...velocity(bob)), 0.01, 'at rest');
    },
  },
];

export const collectionDragRows: Row[] = [
  draggable(ofCollection('draggableBody')),
  mode(ofCollection('dragMode')),
];
