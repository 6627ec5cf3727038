import { setFlagsFromString } from 'node:v8';
import { runInNewContext } from 'node:vm';
import { addBody, addFloor, below, box, fact, world, type Vec3 } from '../../../core/helpers.js';

setFlagsFromString('--expose-gc');
const collect = runInNewContext('gc') as () => void;

/** Bytes of the JS heap that are in use. */
function used(): number {
  for (let i = 0; i < 3; i++) collect();
  return process.memoryUsage().heapUsed;
}

/** Steps until all that runs in one is compiled: that takes its part of the heap once. */
const WARM = 2_000;

/** So far apart that nothing touches. */
const place = (i: number, y: number): Vec3 => [3 * (i % 32), y, 3 * Math.floor(i / 32)];

fact('10,000 steps of 1000 bodies in the air leave less than 64 kB behind', async () => {
  // So light a gravity that they are no faster than 10 m/s in the end.
  for (const rest of ['never', 'auto']) {
    const w = await world({ gravity: [0, -0.1, 0], rest });
    for (let i = 0; i < 1000; i++)
      addBody(w, {
        position: place(i, 0),
        geometry: [box(1, 1, 1)],
        angularVelocity: [0, i % 2, 0],
        ...(i % 10 === 0 && { centerOfMass: [0.1, 0, 0] }),
      });
    w.step(WARM);
    const before = used();
    w.step(10_000);
    // Measured: 6 to 10 kB.
    below(used() - before, 65_536, 'bytes');
  }
});

fact('nor do 2,000 steps of 200 boxes that lie on the ground', async () => {
  const w = await world();
  addFloor(w, 0, { geometry: [box(200, 1, 200)] });
  for (let i = 0; i < 200; i++) addBody(w, { position: place(i, 0.5), geometry: [box(1, 1, 1)] });
  w.step(WARM);
  const before = used();
  w.step(2_000);
  below(used() - before, 65_536, 'bytes');
});
