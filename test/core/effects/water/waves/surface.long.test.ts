import assert from 'node:assert/strict';
import { addBody, box, fact, position, velocity, world, type Vec3 } from '../../../helpers.js';
import { G, CALM, LEVELS, addPool, surfaceOf, fieldOf, energyOf } from './helpers.js';

fact(
  'what heaves in a pool without friction keeps its energy, with that of its waves',
  async () => {
    for (const accuracy of LEVELS) {
      const w = await world({ accuracy } as never);
      const pool = addPool(w, CALM);
      const bodies = [-0.8, 0.8].map((x) =>
        addBody(w, { mass: 500, position: [x, 0.1, 0.2], geometry: [box(1)] }),
      );
      const start = 2 * 500 * G * 0.1 ** 2;
      w.step();
      let least = Infinity;
      let most = 0;
      for (let i = 0; i < 10 / w.timeStep; i++) {
        w.step();
        let energy = energyOf(fieldOf(w, pool));
        for (const body of bodies)
          energy += 250 * velocity(body).reduce((total, v) => total + v * v, 0);
        most = Math.max(most, energy);
        least = Math.min(least, energy);
      }
      // What it has of motion and waves is never more than it began with, but for what of it is in the water that it displaces.
      assert.ok(most < 1.6 * start, `${accuracy}: ${most / start}`);
      assert.ok(least > 0);
    }
  },
);

/** A long channel that swings along its length, and floats that went along with it from the start. */
async function swing(accuracy: string) {
  const w = await world({ accuracy } as never);
  const pool = addPool(w, { size: [40, 2, 4], subdivision: [128, 12], dragCoefficient: 0 });
  const flow = 0.2;
  const k = Math.PI / 40;
  const omega = k * Math.sqrt(2 * G);
  const float = (x: number) =>
    addBody(w, {
      mass: 125,
      position: [x, 0, 0],
      linearVelocity: [(flow / 2) * Math.sin(k * (x + 20)), 0, 0],
      geometry: [box(1, 0.25, 1)],
    });
  const end = float(-15);
  const middle = float(0);
  w.step();
  const surface = surfaceOf(w, pool);
  const { alongWidth } = surface.field;
  for (let at = 0; at < alongWidth.length; at++)
    alongWidth[at] = alongWidth[at]! + flow * Math.sin((Math.PI * (at % 129)) / 128);
  surface.asleep = false;
  const apart = { heave: 0, along: 0 };
  const at: Vec3[] = [];
  for (let i = 1; i <= 36 / w.timeStep; i++) {
    w.step();
    const phase = omega * (w.time - w.timeStep);
    const [x, y] = position(end);
    const heave = ((-flow * k) / omega) * Math.cos(k * (x + 20)) * Math.sin(phase);
    apart.heave = Math.max(apart.heave, Math.abs(y - heave));
    const along = (flow / 2 / omega) * Math.sin(phase);
    apart.along = Math.max(apart.along, Math.abs(position(middle)[0] - along));
    if (i % Math.round(2 / w.timeStep) === 0) at.push([...position(middle)]);
  }
  return { apart, at };
}

fact(
  'a float rides a wave that passes: up and down with it, and along with its water',
  async () => {
    const runs = [];
    for (const accuracy of LEVELS) {
      const { apart, at } = await swing(accuracy);
      assert.ok(apart.heave < 0.002, `${accuracy}: ${apart.heave} of .042`);
      assert.ok(apart.along < 0.03, `${accuracy}: ${apart.along} of .28`);
      runs.push(at);
    }
    const finest = runs.at(-1)!;
    let before = Infinity;
    for (const run of runs.slice(0, -1)) {
      const apart = Math.max(...run.map((at, i) => Math.abs(at[0] - finest[i]![0])));
      assert.ok(apart < before, `${apart} after ${before}`);
      before = apart;
    }
  },
);
