import assert from 'node:assert/strict';
import type { World } from '../../../../../physics-core/inside.js';
import {
  addBody,
  addFloor,
  claim,
  close,
  fact,
  height,
  position,
  random,
  sphere,
  world,
  type Body,
} from '../../../../core/helpers.js';
import { shapeOf } from '../../../../core/world/pairs/scenes.js';

/** Whether two weightless balls, one inside the other, push each other apart. */
function meet(w: World, a: Body, b: Body, far: number): boolean {
  for (const [body, x] of [
    [a, 0],
    [b, 0.6],
  ] as const) {
    body.event('position', [x, far, 0]);
    body.event('linearVelocity', [0, 0, 0]);
    body.event('angularVelocity', [0, 0, 0]);
  }
  w.step(2);
  return Math.abs(position(b)[0] - position(a)[0] - 0.6) > 1e-4;
}

fact(
  '20 collections: exactly the pairs that no disabled collection alone speaks for collide',
  async () => {
    const w = await world({ gravity: [0, 0, 0] });
    const next = random(7);
    const shapes = Array.from({ length: 24 }, () => shapeOf(w));
    const bodies = shapes.map((shape, i) =>
      addBody(w, { geometry: [shape], position: [9, 10 * i, 0] }),
    );
    const lists = Array.from({ length: 20 }, () => shapes.filter(() => next() < 0.3));
    const enabled = lists.map(() => next() < 0.4);
    lists.forEach((collidables, i) =>
      w.add('CollisionCollection', { collidables, enabled: enabled[i] }),
    );
    const wrong: string[] = [];
    let apart = 0;
    for (let a = 0; a < shapes.length; a++) {
      for (let b = a + 1; b < shapes.length; b++) {
        const both = lists.flatMap((list, i) =>
          list.includes(shapes[a]!) && list.includes(shapes[b]!) ? [enabled[i]] : [],
        );
        const expected = both.length === 0 || both.includes(true);
        if (!expected) apart++;
        const far = 1000 + 10 * (a * shapes.length + b);
        if (meet(w, bodies[a]!, bodies[b]!, far) !== expected) wrong.push(`${a} ${b}`);
      }
    }
    assert.ok(apart > 40 && apart < 230, `${apart} pairs kept apart`);
    assert.deepEqual(wrong, []);
  },
);

fact('a collider in 20 collections: exactly its own pairs', async () => {
  const w = await world({ gravity: [0, 0, 0] });
  claim(w, 'not-in-collider');
  const shapes = Array.from({ length: 20 }, () => shapeOf(w));
  const bodies = shapes.map((shape, i) =>
    addBody(w, { geometry: [shape], position: [9, 10 * i, 0] }),
  );
  const collections = shapes.map((_, i) =>
    w.add('CollisionCollection', { collidables: shapes.slice(i) }),
  );
  w.set('collider', collections[10]);
  for (const [a, b, expected] of [
    [9, 12, false],
    [8, 9, false],
    [10, 19, true],
    [18, 19, true],
  ] as const)
    assert.equal(meet(w, bodies[a]!, bodies[b]!, 1000), expected, `${a} and ${b}`);
});

fact('a pair that was kept apart collides as soon as its collection is enabled', async () => {
  const w = await world();
  addFloor(w);
  for (let i = 0; i < 18; i++)
    w.add('CollisionCollection', { collidables: [shapeOf(w, sphere(0.5), { enabled: false })] });
  const [lower, upper] = [shapeOf(w), shapeOf(w)];
  const collection = w.add('CollisionCollection', {
    collidables: [lower, upper],
    enabled: false,
  });
  addBody(w, { fixed: true, position: [0, 2, 0], geometry: [lower] });
  const ball = addBody(w, { position: [0, 4, 0], geometry: [upper] });
  w.advance(2);
  close(height(ball), 0.5, 1e-3, 'm, through it');
  collection.set('enabled', true);
  ball.event('position', [0, 4, 0]);
  ball.event('linearVelocity', [0, 0, 0]);
  w.advance(1);
  close(height(ball), 3, 1e-2, 'm, on it');
});
