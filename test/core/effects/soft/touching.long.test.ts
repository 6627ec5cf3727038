import { equal } from 'node:assert/strict';
import { Links } from '../../../../physics-core/solver/ropes/links.js';
import { RopeSweeps } from '../../../../physics-core/solver/ropes/rope-sweeps.js';
import {
  above,
  addBody,
  addFloor,
  below,
  box,
  close,
  distance,
  fact,
  height,
  sphere,
  world,
  type Vec3,
} from '../../helpers.js';
import { addRope, G, LEVELS, line, place, places } from './helpers.js';

const RADIUS = 0.02;

// ---- on floors and slopes ----------------------------------------------------------------------------------------------

for (const accuracy of LEVELS)
  fact(
    `a rope that falls lies on a floor by its radius, and does not creep, at ${accuracy}`,
    async () => {
      const w = await world({ accuracy });
      addFloor(w);
      const down: Vec3 = [0.8, 0.6, 0];
      const rope = addRope(w, line(20, 2, [-1, 0.05, 0], down), { radius: RADIUS });
      w.advance(4);
      const laid = places(rope);
      for (const [, y] of laid) close(y, RADIUS, 1e-5);
      above(distance(laid[0]!, laid[20]!), 1);
      w.advance(accuracy === 'standard' ? 60 : 5);
      places(rope).forEach((at, i) => close(at, laid[i]!, 1e-5));
    },
  );

/** Calls of a method while a world runs for so long, seconds. */
function callsOf<T>(of: { prototype: T }, method: keyof T & string, run: () => void): number {
  const { prototype } = of;
  const own = prototype[method] as (...args: unknown[]) => unknown;
  let calls = 0;
  Object.assign(prototype as object, {
    [method](this: T, ...args: unknown[]) {
      calls++;
      return own.apply(this, args);
    },
  });
  run();
  Object.assign(prototype as object, { [method]: own });
  return calls;
}

fact(
  'what falls crumpled and slides to a stand takes a few rounds a step, and no sweeps',
  async () => {
    const w = await world();
    addFloor(w);
    const waves = Array.from({ length: 61 }, (_, i): Vec3 => [
      i * 0.04 - 1,
      1 + i * 0.02,
      0.1 * Math.sin(i),
    ]);
    addRope(w, waves, { radius: 0.01, mass: 0.5 });
    let sweeps = 0;
    const rounds = callsOf(Links, 'read', () => {
      sweeps = callsOf(RopeSweeps, 'solve', () => w.advance(2));
    });
    equal(sweeps, 0);
    below(rounds / 240, 6, 'rounds of a step');
  },
);

fact('a rope of radius 0 touches nothing', async () => {
  const w = await world();
  addFloor(w);
  const rope = addRope(w, line(10, 1, [0, 0.1, 0], [1, 0, 0]));
  w.advance(0.5);
  for (const [, y] of places(rope)) below(y, -1);
});

const SLOPE = 0.3;

for (const friction of [0, 0.2, 0.3, 0.35])
  fact(
    `along a slope with friction ${friction} it stays, or slides by g (sin - µ cos)`,
    async () => {
      const w = await world();
      addBody(w, { fixed: true, orientation: [0, 0, 1, SLOPE], geometry: [box(60, 1, 60)] });
      const up: Vec3 = [Math.cos(SLOPE), Math.sin(SLOPE), 0];
      const from: Vec3 = [-(0.5 + RADIUS) * up[1], (0.5 + RADIUS) * up[0], 0];
      const rope = addRope(w, line(20, 2, from, up), { radius: RADIUS, friction });
      const along = (): number[] => places(rope).map(([x, y]) => x * up[0] + y * up[1]);
      const start = along();
      w.advance(0.5);
      const half = along();
      w.advance(0.5);
      const speedsUp = Math.max(0, G * (Math.sin(SLOPE) - friction * Math.cos(SLOPE)));
      along().forEach((end, i) => {
        // What it has after the first step, in which it is laid, does not count.
        close(start[i]! + end - 2 * half[i]!, -speedsUp / 4, 0.01 * speedsUp || 1e-6);
        if (speedsUp === 0) close(end, start[i]!, 1e-5);
      });
    },
  );

// ---- round a drum ------------------------------------------------------------------------------------------------------

/** Of a drum, of the rope on it, and of the middle of that rope, metres. */
const DRUM = 0.1;
const THIN = 0.01;
const BEND = DRUM + THIN;

/** Over a drum about z: so much of it hangs on either side. */
const over = (links: number, left: number, right: number): Vec3[] =>
  Array.from({ length: links + 1 }, (_, i): Vec3 => {
    const way = ((left + right + Math.PI * BEND) * i) / links - left;
    if (way < 0) return [-BEND, way, 0];
    if (way > Math.PI * BEND) return [BEND, Math.PI * BEND - way, 0];
    return [-BEND * Math.cos(way / BEND), BEND * Math.sin(way / BEND), 0];
  });

/** What may hang on one side until it slips, metres, where two metres hang on the other: dT = (µ (T + w r sin) + w r cos) dφ. */
function slips(friction: number): number {
  const steps = 10_000;
  const turn = Math.PI / steps;
  let pull = 2;
  for (let i = 0.5; i < steps; i++) {
    const at = i * turn;
    pull += turn * (friction * (pull + BEND * Math.sin(at)) + BEND * Math.cos(at));
  }
  return pull;
}

for (const accuracy of LEVELS)
  fact(`over a drum it slips from e^(µ φ) on, within 3 %, at ${accuracy}`, async () => {
    for (const friction of [0.15, 0.3])
      for (const share of [0.97, 1.03]) {
        const w = await world({ accuracy });
        const drum = { type: 'Cylinder', radius: DRUM, height: 1 };
        addBody(w, { fixed: true, orientation: [1, 0, 0, Math.PI / 2], geometry: [drum] });
        const longer = share * slips(friction);
        const rope = addRope(w, over(240, 2, longer), { radius: THIN, friction });
        // It settles onto the drum.
        w.advance(1);
        const before = place(rope, 240)[1];
        w.advance(0.5);
        const way = before - place(rope, 240)[1];
        const what = `friction ${friction}, ${share} of what slips: ${way} m`;
        if (share < 1) below(Math.abs(way), 1e-4, what);
        else above(way, 0.02, what);
      }
  });

// ---- what falls on it --------------------------------------------------------------------------------------------------

fact('a ball that falls on a rope between two ends is caught by it', async () => {
  const w = await world();
  const fields = { fixedIndex: [0, 40], radius: RADIUS };
  const rope = addRope(w, line(40, 2, [-1, 0, 0], [1, 0, 0]), fields);
  const ball = addBody(w, { mass: 0.5, position: [0.01, 0.5, 0], geometry: [sphere(0.1)] });
  let most = 0;
  for (let i = 0; i < 240; i++) {
    w.step();
    most = Math.max(most, ...places(rope).map(([, y]) => -y));
  }
  close(height(ball), 0.1 + RADIUS, 0.01);
  below(most, 0.02);
});
