import assert from 'node:assert/strict';
import type { SoftNode } from '../../../../physics-core/nodes/soft/soft-node.js';
import {
  addBody,
  below,
  close,
  distance,
  fact,
  position,
  sphere,
  world,
  type Vec3,
} from '../../helpers.js';
import { addRope, DOWN, G, line, place, places, tie } from './helpers.js';

/** rad/s: how stiff a hand holds. */
const SWIFTNESS = 30;

const LEVEL: Vec3 = [1, 0, 0];

/** A metre in twenty links, from the origin. */
const rope = (...[of, along, fields]: [Parameters<typeof addRope>[0], Vec3, object?]): SoftNode =>
  addRope(of, line(20, 1, [0, 0, 0], along), { mass: 0.2, damping: 2, ...fields }) as SoftNode;

fact('a rope hangs in a hand, lower by its weight, and follows it', async () => {
  const w = await world();
  const held = rope(w, LEVEL);
  const drag = held.drag([0.52, 0.01, 0])!;
  close(drag.point, [0.52, 0.01, 0], 1e-12, 'between two points');
  drag.move([1.5, 1, 0]);
  w.advance(0.5);
  below(distance(drag.point, [1.5, 1 - G / SWIFTNESS ** 2, 0]), 0.05, 'off after half a second');
  w.advance(8);
  close(drag.point, [1.5, 1 - G / SWIFTNESS ** 2, 0], 2e-3, 'held');
  close(drag.point, [1.5, place(held, 10)[1], 0], 0.05, 'by that place');
  drag.end();
  const [, y] = place(held, 10);
  w.advance(0.5);
  close(place(held, 10)[1], y - 1.2, 0.35, 'falls');
});

fact('a hand lifts what a rope is tied to', async () => {
  const w = await world();
  const held = rope(w, DOWN);
  const lamp = addBody(w, { mass: 20, position: [0, -1.1, 0], geometry: [sphere(0.1)] });
  tie(w, held, 20, { body: lamp, position: [0, 0.1, 0] });
  const drag = held.drag([0, 0, 0])!;
  w.advance(1);
  close(drag.point, [0, -G / SWIFTNESS ** 2, 0], 1e-3, 'held');
  drag.move([0, 1, 0]);
  w.advance(2);
  close(position(lamp), [0, -0.1 - G / SWIFTNESS ** 2, 0], 3e-3, 'the lamp');
});

fact('it stretches no rope that hangs fast, and pulls no fixed point away', async () => {
  const w = await world();
  const held = rope(w, DOWN, { fixedIndex: [0] });
  const drag = held.drag([0, 0, 0])!;
  close(drag.point, [0, 0, 0], 1e-12, 'beside the nail');
  drag.move([5, 2, 0]);
  held.drag([0, -1, 0])!.move([3, 3, 0]);
  for (let i = 0; i < 240; i++) {
    w.step();
    below(distance(place(held, 20), [0, 0, 0]), 1 + 1e-5, 'm');
  }
  assert.deepEqual(place(held, 0), [0, 0, 0]);
  const all = rope(w, LEVEL, { fixedIndex: places(held).map((_, i) => i) });
  assert.equal(all.drag([0.5, 0, 0]), undefined);
});

fact('what holds two ropes is held by the hand on one', async () => {
  const w = await world();
  const [one, other] = [rope(w, DOWN), rope(w, LEVEL)];
  const knot = addBody(w, { mass: 0.1, geometry: [sphere(0.01)] });
  tie(w, one, 0, { body: knot });
  tie(w, other, 0, { body: knot });
  const drag = one.drag([0, 0, 0])!;
  w.advance(8);
  below(distance(drag.point, [0, -2 * (G / SWIFTNESS ** 2), 0]), 0.01, 'm');
  close(place(other, 20)[1], -1, 0.05, 'both hang');
});

fact('a pointer means a rope that it misses by a little', async () => {
  const w = await world();
  const held = rope(w, LEVEL, { radius: 0.05 });
  w.step(0);
  const sight = (y: number, beside: [number, number]) =>
    held.seen({ from: [0.5, y, 1], to: [0.5, y, -1], beside });
  close(sight(0.04, [0, 0])!, 0.475, 1e-12, 'its front');
  assert.equal(sight(0.06, [0, 0]), undefined);
  close(sight(0.06, [0, 0.14])!, 0.475, 1e-12, 'beside it');
});
