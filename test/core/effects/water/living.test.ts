import assert from 'node:assert/strict';
import type { SurfaceHit } from '../../../../physics-core/index.js';
import {
  addBody,
  addFloor,
  box,
  claim,
  close,
  fact,
  height,
  position,
  sphere,
  told,
  velocity,
  world,
  type Body,
} from '../../helpers.js';
import { addSea } from './helpers.js';

interface Told {
  event: string;
  water: unknown;
  depth: number;
  speed: number;
  time: number;
}

/** What a body tells of water. */
function listen(body: Body): Told[] {
  const told: Told[] = [];
  for (const event of ['waterenter', 'waterleave'])
    body.on(event as 'sleep', (detail) => told.push({ ...(detail as never as Told), event }));
  return told;
}

fact('what falls in tells once how fast, and what comes out tells once', async () => {
  const w = await world();
  const sea = addSea(w);
  const ball = addBody(w, { mass: 20, position: [0, 2, 0], geometry: [sphere(0.2)] });
  const news = listen(ball);
  w.advance(1.5);
  assert.deepEqual(
    news.map(({ event }) => event),
    ['waterenter'],
  );
  // From 2 m to where its lowest point is in the water: √(2 g 1.8), and less than a step more.
  close(news[0]!.speed, Math.sqrt(2 * 9.8 * 1.8), 0.15);
  assert.ok(news[0]!.depth > 0 && news[0]!.depth < 0.1);
  assert.equal((news[0]!.water as { id: number }).id, sea.id);
  ball.teleport([0, 3, 0]);
  w.step();
  assert.deepEqual(
    news.map(({ event }) => event),
    ['waterenter', 'waterleave'],
  );
});

fact('water that goes is left, whatever takes it away', async () => {
  for (const end of ['remove', 'disable', 'move'] as const) {
    const w = await world();
    const sea = addSea(w);
    const ball = addBody(w, { mass: 20, position: [0, 0, 0], geometry: [sphere(0.2)] });
    const news = listen(ball);
    w.step(4);
    if (end === 'remove') sea.remove();
    else if (end === 'disable') sea.set('enabled', false);
    else sea.set('position', [0, -300, 0]);
    w.step(2);
    assert.deepEqual(
      news.map(({ event }) => event),
      ['waterenter', 'waterleave'],
      end,
    );
  }
});

fact('what floats calmly sleeps, and the world with it, until the water changes', async () => {
  const w = await world({ rest: 'auto' });
  const sea = addSea(w, { damping: 2 });
  const raft = addBody(w, { mass: 250, position: [0, 0.1, 0], geometry: [box(1, 0.5, 1)] });
  const news = listen(raft);
  w.advance(20);
  assert.ok(raft.sleeping);
  close(height(raft), 0, 1e-3);
  sea.set('density', 2000);
  w.step(2);
  assert.ok(!raft.sleeping);
  w.advance(20);
  close(height(raft), 0.125, 1e-3);
  assert.equal(news.length, 1);
});

fact('put back to before, it goes on to the same bits', async () => {
  const w = await world();
  addSea(w);
  const bodies = [0, 1, 2].map((i) =>
    addBody(w, {
      mass: 100 * (i + 1),
      position: [0.8 * i, 1 + i, 0],
      orientation: [1, 0, 1, 0.3 * i],
      geometry: [i === 1 ? sphere(0.5) : box(0.8, 0.5, 1)],
    }),
  );
  const state = (): number[] => bodies.flatMap((body) => [...position(body), ...velocity(body)]);
  for (const before of [0.2, 0.5, 1, 2]) {
    w.advance(before);
    const snapshot = w.snapshot();
    w.advance(1);
    const first = state();
    w.restore(snapshot);
    w.advance(1);
    assert.deepEqual(state(), first);
  }
});

fact('after a reset it all comes about again, with its events', async () => {
  const w = await world();
  addSea(w);
  const ball = addBody(w, { mass: 20, position: [0, 1, 0], geometry: [sphere(0.2)] });
  const news = listen(ball);
  w.advance(2);
  const first = [...position(ball), ...velocity(ball)];
  w.reset();
  w.advance(2);
  assert.deepEqual([...position(ball), ...velocity(ball)], first);
  assert.deepEqual(
    news.map(({ event }) => event),
    ['waterenter', 'waterenter'],
  );
});

fact('what is known of it says how deep it lies, what it displaces, and why', async () => {
  const w = await world();
  const sea = addSea(w, { damping: 6 });
  const raft = addBody(w, { mass: 250, geometry: [box(1, 0.5, 1)] });
  const dry = addBody(w, { position: [0, 9, 0], fixed: true });
  w.advance(5);
  const ask = async (node: unknown) =>
    ((await w.ask('explain', node as never)) as { bullet: Record<string, unknown> }).bullet;
  const { water } = (await ask(raft)) as { water: Record<string, number | string> };
  close(water.depth as number, 0.25, 1e-4);
  close(water.displaced as number, 0.25, 1e-4);
  close(water.carried as number, 250, 0.1);
  assert.match(String(water.why), /floats/);
  assert.equal((await ask(dry)).water, undefined);
  const known = await ask(sea);
  assert.equal(known.bodies, 1);
  close(known.displaced as number, 0.25, 1e-4);
});

fact('a ray meets the surface where it is asked to, from above and from below', async () => {
  const w = await world();
  const sea = w.add('WaterVolume', { size: [10, 4, 10], position: [0, -1, 0] });
  const ball = addBody(w, { fixed: true, position: [0, 0, 0], geometry: [sphere(0.5)] });
  const cast = async (from: number[], to: number[], water = true) =>
    (await w.ask('raycast', from, to, { water })) as SurfaceHit | null;
  const hit = await cast([2, 5, 0], [2, -5, 0]);
  assert.equal(hit!.node.id, sea.id);
  close(hit!.position[1], 1, 1e-12);
  assert.deepEqual(hit!.normal, [0, 1, 0]);
  close(hit!.fraction, 0.4, 1e-12);
  assert.deepEqual((await cast([2, -2, 0], [2, 5, 0]))!.normal.map(Math.abs), [0, 1, 0]);
  assert.equal(await cast([2, 5, 0], [2, -5, 0], false), null);
  assert.equal(await cast([7, 5, 0], [7, -5, 0]), null);
  // The ball is below the surface, and above it where the water is lower.
  assert.equal((await cast([0, 5, 0], [0, -5, 0]))!.node.id, sea.id);
  sea.set('position', [0, -3, 0]);
  assert.equal((await cast([0, 5, 0], [0, -5, 0]))!.node.id, ball.id);
});

fact('what no water can have is told, and nothing comes of it', async () => {
  const w = await world();
  claim(w, 'out-of-range');
  const sea = addSea(w, { density: -5, size: [-1, 2, 3], dragCoefficient: -1 });
  const raft = addBody(w, { mass: 250, geometry: [box(1, 0.5, 1)] });
  w.step();
  assert.equal(told(w, 'out-of-range').length, 3);
  assert.match(told(w, 'out-of-range').join(), /density/);
  // Without density, or without any size, there is none.
  for (const [field, value] of [
    ['density', 0],
    ['size', [0, 0, 0]],
    ['size', [50, 0, 50]],
  ] as const) {
    sea.set('density', 1000);
    sea.set('size', [50, 50, 50]);
    sea.set(field, value);
    raft.teleport([0, 0, 0], [0, 1, 0, 0], { linearVelocity: [0, 0, 0] });
    w.step(10);
    close(velocity(raft)[1], -9.8 * 10 * w.timeStep, 1e-5);
  }
});

fact('a body that the world has no outline of, or none that is solid, goes through', async () => {
  const w = await world();
  addSea(w);
  const mesh = addBody(w, {
    fixed: true,
    geometry: [
      { type: 'IndexedTriangleSet', coord: [0, 0, 0, 1, 0, 0, 0, 0, 1], index: [0, 1, 2] },
    ],
  });
  const nothing = addBody(w, { mass: 1, position: [5, 0, 0], geometry: [] });
  w.step(5);
  assert.equal(height(mesh), 0);
  close(velocity(nothing)[1], -9.8 * 5 * w.timeStep, 1e-5);
});

fact('an edit of water wakes what is in it and what it comes to, and nobody else', async () => {
  const w = await world({ rest: 'auto' });
  const pool = w.add('WaterVolume', { size: [4, 4, 4], position: [0, -2, 0] });
  addFloor(w, -4);
  const within = addBody(w, { mass: 2000, position: [0, -3.5, 0], geometry: [box(1)] });
  const beside = addBody(w, { position: [6, -3.5, 0], geometry: [box(1)] });
  const far = addBody(w, { position: [20, -3.5, 0], geometry: [box(1)] });
  w.advance(4);
  assert.ok(within.sleeping && beside.sleeping && far.sleeping);
  pool.set('damping', 2);
  w.step();
  assert.deepEqual([within.sleeping, beside.sleeping, far.sleeping], [false, true, true]);
  pool.set('position', [6, -2, 0]);
  w.step();
  assert.deepEqual([within.sleeping, beside.sleeping, far.sleeping], [false, false, true]);
});
