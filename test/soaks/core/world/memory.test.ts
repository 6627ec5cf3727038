import { setFlagsFromString } from 'node:v8';
import { runInNewContext } from 'node:vm';
import { addBody, addFloor, below, box, fact, world, type Vec3 } from '../../../core/helpers.js';
import { leavesNoTrace } from '../../../core/no-trace.js';

// Code that V8 compiles while it runs lies on the same heap: up to 75 kB over these steps, more or
// less by how busy the machine is. Without compilers, and with each function's feedback made at its
// first call, what grows is what we leave behind.
for (const flag of [
  '--expose-gc',
  '--no-opt',
  '--no-maglev',
  '--no-sparkplug',
  '--no-lazy-feedback-allocation',
  '--no-flush-bytecode',
])
  setFlagsFromString(flag);
const collect = runInNewContext('gc') as () => void;

/** Bytes of the JS heap that are in use. */
function used(): number {
  for (let i = 0; i < 3; i++) collect();
  return process.memoryUsage().heapUsed;
}

/** Steps until all that runs in one has run: its feedback takes its part of the heap once. */
const WARM = 1_000;

/** So far apart that nothing touches. */
const place = (i: number, y: number): Vec3 => [3 * (i % 32), y, 3 * Math.floor(i / 32)];

fact('10,000 steps of 300 bodies in the air leave less than 16 kB behind', async () => {
  // So light a gravity that they are no faster than 10 m/s in the end.
  for (const rest of ['never', 'auto']) {
    const w = await world({ gravity: [0, -0.1, 0], rest });
    for (let i = 0; i < 300; i++)
      addBody(w, {
        position: place(i, 0),
        geometry: [box(1, 1, 1)],
        angularVelocity: [0, i % 2, 0],
        ...(i % 10 === 0 && { centerOfMass: [0.1, 0, 0] }),
      });
    w.step(WARM);
    const before = used();
    w.step(10_000);
    // Measured: 0 to .4 kB.
    below(used() - before, 16_384, 'bytes');
  }
});

fact('nor do 2,000 steps of 50 boxes that lie on the ground leave a quarter of it', async () => {
  const w = await world();
  addFloor(w, 0, { geometry: [box(200, 1, 200)] });
  for (let i = 0; i < 50; i++) addBody(w, { position: place(i, 0.5), geometry: [box(1, 1, 1)] });
  w.step(WARM);
  const before = used();
  w.step(2_000);
  below(used() - before, 16_384, 'bytes');
});

fact(
  'nor do 1,000 steps of particles that fly, whirl in the wind, bounce off boxes and push them',
  async () => {
    const w = await world();
    addFloor(w, 0, { geometry: [box(200, 1, 200)] });
    for (let i = 0; i < 9; i++) addBody(w, { position: [3 * i, 0.5, 0], geometry: [box(1, 1, 1)] });
    w.add('ParticleSystem', {
      emitter: {
        type: 'ConeEmitter',
        position: [6, 2, 0],
        speed: 6,
        mass: 0.001,
        surfaceArea: 1e-4,
      },
      physics: [
        { type: 'ForcePhysicsModel', force: [0, -0.0098, 0] },
        { type: 'WindPhysicsModel', speed: 2, gustiness: 0.5, turbulence: 0.5 },
      ],
      maxParticles: 300,
      particleLifetime: 2,
      collides: true,
      pushes: true,
      bounce: 0.5,
    });
    w.step(WARM);
    const before = used();
    w.step(1_000);
    below(used() - before, 16_384, 'bytes');
  },
);

fact('nor do 2,000 steps of ropes that swing, lie on the ground and carry balls', async () => {
  const w = await world();
  addFloor(w, -3, { geometry: [box(200, 1, 200)] });
  const along = (x: number, y: number): Vec3[] => [
    [x, y, 0],
    [x + 1, y, 0],
  ];
  w.add('Rope', { points: along(0, 0), segments: 8, fixedIndex: [0] });
  w.add('Rope', { points: along(5, -2.9), segments: 8 });
  const softBody = w.add('Rope', { points: along(10, 0), segments: 8, fixedIndex: [0] });
  const body = addBody(w, { position: [11, 0, 0], geometry: [{ type: 'Sphere', radius: 0.1 }] });
  w.add('SoftBodyAttachment', { softBody, index: 8, body });
  w.step(WARM);
  const before = used();
  w.step(2_000);
  below(used() - before, 16_384, 'bytes');
});

fact('ropes that come and go leave nothing of the heap behind', async () => {
  const w = await world();
  addFloor(w, -3);
  const body = addBody(w, { position: [1, 0, 0], fixed: true });
  await leavesNoTrace(w, () => {
    for (let i = 0; i < 10; i++) {
      const points = [
        [0, 0, 0],
        [1, 0, 0],
      ];
      const softBody = w.add('Rope', { points, segments: 8 });
      const tied = w.add('SoftBodyAttachment', { softBody, index: 8, body });
      w.step(5);
      if (i % 2) tied.remove();
      softBody.remove();
      if (!(i % 2)) tied.remove();
      w.step(1);
    }
  });
});

fact('nor do 2,000 steps of cloths that swing, lie on the ground and carry balls', async () => {
  const w = await world();
  addFloor(w, -3, { geometry: [box(200, 1, 200)] });
  const sheet = { size: [1, 1], subdivision: [4, 4], fixedIndex: [20, 24] };
  w.add('Cloth', sheet);
  w.add('Cloth', { geometry: { ...box(1, 0.2, 1), translation: [5, -2.5, 0] } });
  const softBody = w.add('Cloth', { ...sheet, wind: [0, 0, 2] });
  const body = addBody(w, {
    mass: 0.5,
    position: [0, -0.5, 0],
    geometry: [{ type: 'Sphere', radius: 0.1 }],
  });
  w.add('SoftBodyAttachment', { softBody, index: 2, body });
  w.step(WARM);
  const before = used();
  w.step(2_000);
  below(used() - before, 16_384, 'bytes');
});

fact('cloths that come and go leave nothing of the heap behind', async () => {
  const w = await world();
  addFloor(w, -3);
  const body = addBody(w, { position: [0.5, 0.5, 0], fixed: true });
  await leavesNoTrace(w, () => {
    for (let i = 0; i < 10; i++) {
      const softBody = w.add('Cloth', { size: [1, 1], subdivision: [3, 3], fixedIndex: [12, 13] });
      const tied = w.add('SoftBodyAttachment', { softBody, index: 15, body });
      w.step(5);
      if (i % 2) tied.remove();
      softBody.remove();
      if (!(i % 2)) tied.remove();
      w.step(1);
    }
  });
});

fact('systems that come and go leave nothing of the heap behind', async () => {
  const w = await world();
  addFloor(w);
  await leavesNoTrace(w, () => {
    for (let i = 0; i < 10; i++) {
      const surface = { type: 'Sphere', radius: 0.4 };
      const system = w.add('ParticleSystem', {
        emitter: { type: 'SurfaceEmitter', surface, mass: 0.001 },
        collides: true,
        pushes: true,
      });
      w.step(5);
      system.remove();
      w.step(1);
    }
  });
});
