import assert from 'node:assert/strict';
import {
  addBody,
  addFloor,
  box,
  fact,
  height,
  position,
  velocity,
  world,
} from '../../../helpers.js';
import type { World } from '../../../../../physics-core/inside.js';
import type { WaterVolumeNode } from '../../../../../physics-core/water.js';
import { steppingOf } from '../../../thread/at-once.js';
import { CALM, addPool, surfaceOf, fieldOf, sum, volumeOf, energyOf } from './helpers.js';

fact('a body that floats still leaves the surface flat, and that sleeps', async () => {
  const w = await world();
  const pool = addPool(w);
  const body = addBody(w, { mass: 500, geometry: [box(1)] });
  w.advance(2);
  const surface = surfaceOf(w, pool);
  assert.equal(surface.asleep, true);
  assert.ok(surface.field.heights.every((each) => each === 0));
  assert.ok(Math.abs(height(body)) < 1e-6);
});

fact('a box that falls in lifts the water by what it displaces, at any moment', async () => {
  const w = await world();
  const pool = addPool(w, { size: [8, 2, 6], waveDamping: 1 });
  const body = addBody(w, { mass: 500, position: [0.3, 1, 0.4], geometry: [box(1)] });
  w.advance(40);
  const field = fieldOf(w, pool);
  assert.ok(Math.abs(volumeOf(field) / 0.5 - 1) < 1e-5, `${volumeOf(field)}`);
  // What it floats in is higher by what it displaces.
  assert.ok(Math.abs(height(body) - 0.5 / 48) < 1e-5, `${height(body)}`);
  body.remove();
  w.advance(0.1);
  assert.ok(Math.abs(volumeOf(field)) < 1e-9);
});

fact('what floats and its water keep their momentum, whatever brakes it', async () => {
  for (const fields of [{}, CALM]) {
    const w = await world();
    const pool = addPool(w, { size: [60, 2, 60], subdivision: [128], ...fields });
    const body = addBody(w, {
      mass: 500,
      position: [0.3, 0, 0.7],
      orientation: [0, 1, 0, 0.4],
      linearVelocity: [2, 0, 1],
      geometry: [box(2, 0.5, 1)],
    });
    for (let i = 0; i < 10; i++) {
      w.advance(0.4);
      const { alongWidth, alongLength, cellArea } = fieldOf(w, pool);
      const v = velocity(body);
      const x = 500 * v[0] + 1000 * cellArea * sum(alongWidth);
      const z = 500 * v[2] + 1000 * cellArea * sum(alongLength);
      assert.ok(Math.abs(x / 1000 - 1) < 1e-6, `${x}`);
      assert.ok(Math.abs(z / 500 - 1) < 1e-6, `${z}`);
    }
    assert.ok(velocity(body)[0] < 1.99);
  }
});

fact(
  'what rests is woken by a wave that comes to it, and a surface at rest asks for no step',
  async () => {
    const w = await world({ rest: 'auto' } as never);
    const pool = addPool(w, { waveDamping: 0.5 });
    const body = addBody(w, { mass: 500, position: [-6, 0, 0], geometry: [box(1)] });
    w.advance(4);
    assert.equal(body.sleeping, true);
    assert.equal(steppingOf(w).bodies.goesOn, false);
    const stone = addBody(w, { mass: 5000, position: [6, 2, 0], geometry: [box(1)] });
    let most = 0;
    for (let i = 0; i < 600; i++) {
      w.step();
      most = Math.max(most, Math.abs(height(body)));
    }
    assert.ok(most > 0.01, `${most}`);
    stone.remove();
    w.advance(120);
    assert.equal(surfaceOf(w, pool).asleep, true);
    assert.equal(body.sleeping, true);
  },
);

fact(
  'after restore() the surface goes on bit for bit, and after reset() it begins anew',
  async () => {
    const w = await world();
    const pool = addPool(w);
    const body = addBody(w, { mass: 300, position: [2, 1, 1], geometry: [box(1)] });
    const run = (seconds: number) => {
      w.advance(seconds);
      const { heights, alongWidth } = fieldOf(w, pool);
      return [[...position(body)], [...heights], [...alongWidth]];
    };
    const first = run(1);
    const kept = JSON.parse(JSON.stringify(w.snapshot())) as ReturnType<World['snapshot']>;
    const later = run(1);
    w.restore(kept);
    assert.deepEqual(run(1), later);
    w.reset();
    assert.deepEqual(run(1), first);
  },
);

fact('open edges let waves out: less than a hundredth of their energy stays', async () => {
  const w = await world();
  const pool = addPool(w, { edges: 'OPEN' });
  const stone = addBody(w, { mass: 3000, position: [0, 1, 0], geometry: [box(1)] });
  let most = 0;
  for (let i = 0; i < 240; i++) {
    w.step();
    most = Math.max(most, energyOf(fieldOf(w, pool)));
  }
  stone.remove();
  w.advance(0.1);
  const thrown = energyOf(fieldOf(w, pool));
  w.advance(10);
  assert.ok(energyOf(fieldOf(w, pool)) < 0.01 * Math.max(most, thrown));
});

fact(
  'bodies a thousand times lighter and heavier than water, and one as large as its basin, stay where they may',
  async () => {
    for (const density of [0.5, 1e6])
      for (const size of [2, 4]) {
        const w = await world();
        const pool = addPool(w, { size: [4, 2, 4], ...CALM });
        const body = addBody(w, {
          mass: density * size * size,
          position: [0.1, 3, 0.2],
          geometry: [box(size, 1, size)],
        });
        w.advance(10);
        const { heights } = fieldOf(w, pool);
        assert.ok(heights.every((each) => Math.abs(each) < 10));
        assert.ok(height(body) < 30, `${height(body)}`);
      }
  },
);

fact('water that weighs nothing has no waves, and does not keep a world awake', async () => {
  const w = await world({ gravity: [0, 0, 0], rest: 'auto' } as never);
  const pool = addPool(w);
  addBody(w, { mass: 500, position: [0, 2, 0], linearVelocity: [0, -2, 0], geometry: [box(1)] });
  w.advance(10);
  assert.ok(fieldOf(w, pool).heights.every((each) => each === 0));
  assert.equal(surfaceOf(w, pool).asleep, true);
});

fact('who draws it sees the heights, and a version that changes with them', async () => {
  const w = await world();
  const pool = addPool(w, { subdivision: [8, 4] }) as WaterVolumeNode;
  assert.equal(pool.surface, undefined);
  addBody(w, { mass: 300, position: [2, 0.6, 1], geometry: [box(1)] });
  w.step();
  const { columns, rows, width, length, heights, version } = pool.surface!;
  assert.deepEqual([columns, rows, width, length, heights.length], [8, 4, 20, 20, 32]);
  assert.equal(pool.surface!.version, version);
  w.advance(1);
  const later = pool.surface!;
  assert.ok(later.version > version);
  assert.ok(later.heights.some((each) => each > 1e-3));
  pool.set('waves', false);
  w.step();
  assert.equal(pool.surface, undefined);
});

fact('little water that brakes much is taken along, and throws nothing back', async () => {
  for (const fields of [{ damping: 200 }, { dragCoefficient: 20 }, {}])
    for (const accuracy of ['game', 'standard'] as const) {
      const w = await world({ accuracy });
      w.add('WaterVolume', {
        size: [6, 0.5, 6],
        position: [0, -0.25, 0],
        waves: true,
        subdivision: [32, 32],
        ...fields,
      });
      addFloor(w, -0.5);
      const cube = addBody(w, {
        mass: 5000,
        position: [-2, 0, 0],
        linearVelocity: [8, 0, 0],
        geometry: [box(1)],
      });
      let fastest = 0;
      for (let i = 0; i < 2 / w.timeStep; i++) {
        w.step();
        fastest = Math.max(fastest, Math.hypot(...velocity(cube)));
      }
      assert.ok(fastest < 8, `${fastest} m/s`);
    }
});

fact('a paddle that is carried makes waves, and stands in the water where it stops', async () => {
  const w = await world();
  const size = [40, 1, 4];
  const pool = addPool(w, { size, position: [0, -0.5, 0], subdivision: [160, 8] });
  const paddle = addBody(w, {
    fixed: true,
    position: [-18, -0.25, 0],
    geometry: [box(0.5, 1, 4)],
  });
  w.step();
  const field = fieldOf(w, pool);
  for (let i = 1; i < 2 / w.timeStep; i++) {
    paddle.set('position', [-18 + 0.05 * Math.sin(Math.PI * i * w.timeStep), -0.25, 0]);
    w.step();
  }
  const far = field.heights.slice(150, 160).map(Math.abs);
  assert.ok(field.crest > 0.02, `${field.crest} m`);
  assert.ok(Math.max(...far) < 1e-3, 'no wave is faster than the root of g times the depth');
  w.advance(8);
  // Three quarters of it are below the surface, and as much more or less as a wave is high that stands at it.
  const levelOf = (deep: number): number => (0.5 * 4 * deep) / (size[0]! * size[2]!);
  const aside = 2 * field.crest;
  const near = [levelOf(0.75 - aside), field.level, levelOf(0.75 + aside)];
  assert.ok(near[0]! < near[1]! && near[1]! < near[2]!, near.join(' '));
});

fact('where nothing has weight a surface has no waves, and brakes all the same', async () => {
  for (const waves of [false, true]) {
    const w = await world({ gravity: [0, 0, 0] });
    w.add('WaterVolume', { size: [40, 40, 40], waves, dragCoefficient: 1, damping: 0 });
    const cube = addBody(w, { mass: 100, linearVelocity: [2, 0, 0], geometry: [box(1)] });
    w.advance(1);
    // v / (1 + k v t), k being ½ ρ c A / m.
    const speed = 2 / (1 + 5 * 2);
    assert.ok(Math.abs(velocity(cube)[0] / speed - 1) < 1e-3, `${velocity(cube)[0]} of ${speed}`);
  }
});
