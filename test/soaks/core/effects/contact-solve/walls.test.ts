import assert from 'node:assert/strict';
import {
  addBody,
  addFloor,
  below,
  box,
  distance,
  fact,
  position,
  world,
  type Body,
} from '../../../../core/helpers.js';

// Of so many pairs in touch that a matrix in each step would be too dear.

const ROWS = 14;
const LONG = 16;

async function wall() {
  const w = await world({ rest: 'auto' });
  addFloor(w);
  // The world runs before it is built.
  w.advance(1);
  const bodies: Body[] = [];
  for (let y = 0; y < ROWS; y++)
    for (let x = 0; x < LONG - (y % 2); x++)
      bodies.push(addBody(w, { position: [x + (y % 2) / 2, y + 0.5, 0], geometry: [box(1)] }));
  const before = bodies.map(position);
  const moved = (): number =>
    Math.max(...bodies.map((body, i) => distance(position(body), before[i]!)));
  return { w, bodies, moved };
}

fact('a wall of 217 bricks that touch side by side stands, and falls asleep', async () => {
  const { w, bodies, moved } = await wall();
  for (let i = 0; i < 40; i++) {
    w.advance(0.25);
    below(moved(), 2e-3, 'm');
    if (bodies.every(({ sleeping }) => sleeping)) return;
  }
  assert.fail(`${bodies.filter(({ sleeping }) => !sleeping).length} are awake after 10 s`);
});
