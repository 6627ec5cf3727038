import assert from 'node:assert/strict';
import type { World } from '../../../physics-core/inside.js';
import {
  addBody,
  addJoint,
  below,
  claim,
  close,
  codes,
  fact,
  position,
  told,
  world,
} from '../../core/helpers.js';

// What is meant to hang a page, or comes from a broken exporter: bounded time and memory, one clear problem each.

/** Seconds of the processor that each may take; they were measured to take a tenth of that. */
const SOON = 10;

async function soon(act: (w: World) => void): Promise<World> {
  const w = await world();
  const before = process.cpuUsage();
  act(w);
  const { user, system } = process.cpuUsage(before);
  below((user + system) / 1e6, SOON, 's');
  return w;
}

const told1 = (w: World, code: string, says: RegExp): void => {
  claim(w, code);
  assert.equal(told(w, code).length, 1);
  assert.match(told(w, code)[0]!, says);
};

fact('a milliard iterations are refused', async () => {
  const w = await soon((made) => made.set('iterations', 1e9));
  told1(w, 'out-of-range', /iterations="1000000000" is beyond ±1000, .* 10 is used/);
});

fact('grids and strips that claim more points than there are take no time', async () => {
  const grid = { type: 'ElevationGrid', xDimension: 2 ** 31 - 1, zDimension: 2 ** 31 - 1 };
  const strip = {
    type: 'TriangleStripSet',
    coord: [0, 0, 0, 1, 0, 0, 0, 1, 0],
    stripCount: [2 ** 31 - 1, -7, 2 ** 31 - 1],
  };
  const w = await soon((made) => {
    addBody(made, { geometry: [grid] });
    addBody(made, { geometry: [strip] });
    made.step();
  });
  told1(w, 'bad-value', /ElevationGrid of \d+ points has more than 1048576; it is left out/);
});

fact('a mesh of three million numbers stands, and one of more points is left out', async () => {
  const w = await soon((made) => {
    for (const coord of [new Float32Array(3e6), new Float32Array(3.3e6)])
      addBody(made, { fixed: true, geometry: [{ type: 'TriangleSet', coord }] });
    made.step();
  });
  told1(w, 'bad-value', /TriangleSet of 1100000 points has more than 1048576; it is left out/);
});

fact('megabytes in a number, in a name and in a list', async () => {
  const w = await soon((made) => {
    const body = addBody(made);
    body.set('mass', '9'.repeat(4e6));
    body.set('position', '1 '.repeat(1e6));
    body.set('forces', '0 '.repeat(3e6));
    body.set('x'.repeat(4e6), 1);
    made.step();
  });
  claim(w, 'bad-value', 'unknown-attribute');
  assert.deepEqual(codes(w).sort(), ['bad-value', 'bad-value', 'unknown-attribute']);
  for (const { message } of w.problems) below(message.length, 200, 'characters');
});

fact(
  'ten thousand joints on one body hold it, by Bullet where they are too many to solve',
  async () => {
    for (const joints of [100, 10_000]) {
      const w = await soon((made) => {
        const body = addBody(made);
        for (let i = 0; i < joints; i++)
          addJoint(made, 'BallJoint', { body1: body, anchorPoint: [i % 7, i % 5, i % 3] });
        made.step(3);
        close(position(body), [0, 0, 0], 1e-3, 'm');
      });
      if (joints > 100) told1(w, 'joint-solve', /have no direct solution; they are held less well/);
    }
  },
);

fact('five thousand spaces in one another, in a circle, list what is in them', async () => {
  await soon((made) => {
    const shape = made.add('CollidableShape', { shape: [{ type: 'Box' }] });
    const first = made.add('CollisionSpace', { collidables: [shape] });
    let last = first;
    for (let i = 0; i < 5000; i++) last = made.add('CollisionSpace', { collidables: [last] });
    first.set('collidables', [last, shape]);
    const collection = made.add('CollisionCollection', { collidables: [last] });
    made.step();
    assert.equal((collection as unknown as { lists(node: unknown): boolean }).lists(shape), true);
  });
});

fact('what stands in another a thousand deep is cut, as nodes and as data', async () => {
  const w = await soon((made) => {
    let node = made.add('CollidableShape', { shape: [{ type: 'Box' }] });
    for (let i = 0; i < 150; i++) node = made.add('CollidableOffset', { collidable: node });
    made.step();
  });
  told1(w, 'misplaced', /would be more than 100 deep in one another/);
  const deep = await soon((made) => {
    let data: Record<string, unknown> = { type: 'CollidableShape', shape: [{ type: 'Box' }] };
    for (let i = 0; i < 20_000; i++) data = { type: 'CollidableOffset', collidable: data };
    addBody(made, { geometry: [data] });
    made.step();
  });
  told1(deep, 'misplaced', /stands in 100 others; it is left out/);
});
