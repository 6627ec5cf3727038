import assert from 'node:assert/strict';
import { chainMasses } from '../../../../references/hanging-chain.js';
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
  position,
  spin,
  sphere,
  velocity,
  WEIGHTLESS,
  world,
  type Vec3,
} from '../../helpers.js';
import { addRope, G, LEVELS, line, place, places, tie } from './helpers.js';

// Links are longer than what they lie on is wide: nothing is touched by points.

const RADIUS = 0.01;
const BAR = 0.01;

const bar = (length = 1) => ({ type: 'Cylinder', radius: BAR, height: length });

/** About z. */
const addBar = (to: Parameters<typeof addBody>[0], at: Vec3, fields: object = {}) =>
  addBody(to, {
    fixed: true,
    position: at,
    orientation: [1, 0, 0, Math.PI / 2],
    geometry: [bar()],
    ...fields,
  });

/** How near the links of a rope in the x-y plane come to a place there. */
function nearest(points: readonly Vec3[], [x, y]: readonly number[]): number {
  let least = Infinity;
  for (let i = 1; i < points.length; i++) {
    const [a, b] = points[i - 1]!;
    const u = points[i]![0] - a;
    const v = points[i]![1] - b;
    const share = Math.max(0, Math.min(1, ((x! - a) * u + (y! - b) * v) / (u * u + v * v)));
    least = Math.min(least, Math.hypot(a + share * u - x!, b + share * v - y!));
  }
  return least;
}

// ---- what it lies on -----------------------------------------------------------------------------------------------------

for (const accuracy of LEVELS) {
  fact(
    `a rope of long links lies across two thin bars, and holds there, at ${accuracy}`,
    async () => {
      const w = await world({ accuracy });
      const bars: Vec3[] = [
        [-0.2, 0, 0],
        [0.2, 0, 0],
      ];
      for (const at of bars) addBar(w, at);
      const fields = { radius: RADIUS, friction: 1, damping: 2 };
      const rope = addRope(w, line(10, 1, [-0.55, 0.05, 0], [1, 0, 0]), fields);
      for (let n = 0; n < 20; n++) {
        w.advance(0.1);
        for (const at of bars) above(nearest(places(rope), at), BAR + RADIUS - 1e-3);
      }
      for (const at of bars) close(nearest(places(rope), at), BAR + RADIUS, 1e-4);
    },
  );

  fact(`it lies round the edge of a box, and does not creep, at ${accuracy}`, async () => {
    const w = await world({ accuracy });
    addBody(w, { fixed: true, position: [-0.5, -0.5, 0], geometry: [box(1, 1, 1)] });
    const fields = { radius: RADIUS, friction: 0.8, damping: 2 };
    const rope = addRope(w, line(10, 1, [-0.63, RADIUS, 0], [1, 0, 0]), fields);
    w.advance(8);
    const laid = places(rope);
    close(nearest(laid, [0, 0]), RADIUS, 1e-4);
    // The last link on it is a lever.
    for (const [x, y] of laid) if (x < -0.15) close(y, RADIUS, 1e-5);
    w.advance(accuracy === 'standard' ? 60 : 5);
    close(place(rope, 0), laid[0]!, 1e-5);
  });
}

fact('a link that lies flat on something narrow does not rock', async () => {
  const w = await world();
  addBody(w, { fixed: true, position: [0, -0.5, 0], geometry: [box(0.05, 1, 1)] });
  const rope = addRope(w, line(1, 0.1, [-0.06, RADIUS, 0], [1, 0, 0]), { radius: RADIUS });
  w.advance(0.5);
  const laid = places(rope);
  w.advance(10);
  places(rope).forEach((at, i) => {
    close(at[1], RADIUS, 1e-5);
    close(at, laid[i]!, 1e-5);
  });
});

const SLOPE = 0.3;

for (const friction of [0, 0.2, 0.35])
  fact(
    `a link on two bars of a slope stays, or slides by g (sin - µ cos), with friction ${friction}`,
    async () => {
      const w = await world();
      const up: Vec3 = [Math.cos(SLOPE), Math.sin(SLOPE), 0];
      const at = (way: number, over: number): Vec3 => [
        way * up[0] - over * up[1],
        way * up[1] + over * up[0],
        0,
      ];
      for (const way of [-0.2, 0.2]) addBar(w, at(way, -BAR - RADIUS));
      const rope = addRope(w, [at(-0.6, 0), at(0.6, 0)], { radius: RADIUS, friction });
      const along = (): number => place(rope, 0)[0] * up[0] + place(rope, 0)[1] * up[1];
      // In the step in which it is laid nothing presses it yet: what holds it brings it to a stand first.
      if (friction > Math.tan(SLOPE)) w.advance(0.15);
      const start = along();
      w.advance(0.15);
      const half = along();
      w.advance(0.15);
      const speedsUp = Math.max(0, G * (Math.sin(SLOPE) - friction * Math.cos(SLOPE)));
      const gains = speedsUp * 0.15 ** 2;
      close(start + along() - 2 * half, -gains, 0.01 * gains || 1e-7);
      if (speedsUp === 0) close(along(), start, 1e-6);
    },
  );

fact('two balls on a link across a bar are a balance: the heavier one goes down', async () => {
  for (const mass of [1, 1.3]) {
    const w = await world();
    addBar(w, [0, 0, 0]);
    const rope = addRope(w, line(1, 1, [-0.5, 0.05, 0], [1, 0, 0]), { radius: RADIUS });
    const balls = [1, mass].map((each, i) => {
      const at: Vec3 = [i - 0.5, 0.05, 0];
      const body = addBody(w, { mass: each, position: at, geometry: [sphere(0.05)] });
      tie(w, rope, i, { body });
      return body;
    });
    w.advance(0.5);
    const [one, two] = balls.map(height);
    close((one! + two!) / 2, BAR + RADIUS, 0.002);
    if (mass === 1) close(one!, two!, 1e-6);
    else above(one! - two!, 0.1);
  }
});

fact('a rope over a thin bar comes to rest, and sleeps', async () => {
  const w = await world({ rest: 'auto' });
  addFloor(w, -0.2);
  addBar(w, [0, 0, 0]);
  const fields = { radius: RADIUS, friction: 1, damping: 3 };
  const rope = addRope(w, line(10, 1, [-0.5, 0.05, 0], [1, 0, 0]), fields);
  w.advance(15);
  const laid = places(rope);
  close(nearest(laid, [0, 0]), BAR + RADIUS, 1e-4);
  w.advance(20);
  places(rope).forEach((at, i) => close(at, laid[i]!, 1e-12));
});

// ---- what comes to it ------------------------------------------------------------------------------------------------------

for (const accuracy of LEVELS)
  fact(
    `a marble that falls between two points of a taut rope is caught, at ${accuracy}`,
    async () => {
      for (const high of [0.3, 3]) {
        const w = await world({ accuracy });
        const fields = { fixedIndex: [0, 10], radius: RADIUS, mass: 0.1 };
        addRope(w, line(10, 1, [-0.5, 0, 0], [1, 0, 0]), fields);
        const at: Vec3 = [0.055, high, 0];
        const marble = addBody(w, { mass: 0.02, position: at, geometry: [sphere(0.01)] });
        w.advance(2);
        close(height(marble), 0.01 + RADIUS, 0.005);
      }
    },
  );

fact('what flies past a rope does not touch it', async () => {
  const w = await world(WEIGHTLESS);
  const points = line(10, 1, [-0.5, 0, 0], [1, 0, 0]);
  const rope = addRope(w, points, { radius: RADIUS });
  for (const side of [-1, 1])
    addBody(w, {
      mass: 1,
      position: [0.05, 1, side * (0.01 + RADIUS + 0.001)],
      linearVelocity: [0, -15, 0],
      geometry: [sphere(0.01)],
    });
  w.advance(0.3);
  places(rope).forEach((at, i) => close(at, points[i]!, 1e-12));
});

fact('a thin bar that falls across a taut rope lies on it', async () => {
  const w = await world();
  const fields = { fixedIndex: [0, 10], radius: RADIUS, mass: 0.1, friction: 1 };
  for (const z of [-0.3, 0.3]) addRope(w, line(10, 1, [-0.5, 0, z], [1, 0, 0]), fields);
  const fallen = addBar(w, [0.05, 0.3, 0], { fixed: false, mass: 0.2 });
  w.advance(3);
  close(position(fallen), [0.05, BAR + RADIUS, 0], 0.01);
});

for (const accuracy of LEVELS)
  fact(`a marble that hits a free rope gives it what it loses, at ${accuracy}`, async () => {
    const w = await world({ ...WEIGHTLESS, accuracy });
    const fields = { radius: RADIUS, mass: 0.1, friction: 0.5 };
    const rope = addRope(w, line(4, 0.4, [-0.2, 0, 0], [1, 0, 0]), fields);
    const marble = addBody(w, {
      mass: 0.05,
      position: [0.07, 0.2, 0.005],
      linearVelocity: [0.3, -2, 0],
      geometry: [sphere(0.01)],
    });
    w.step();
    const start = w.time;
    w.step();
    const dt = w.time - start;
    const share = chainMasses(4, 0.1);
    const momentum = (was: readonly Vec3[], now: readonly Vec3[]): Vec3 =>
      velocity(marble).map(
        (v, k) =>
          0.05 * v + now.reduce((sum, at, i) => sum + (share[i]! * (at[k]! - was[i]![k]!)) / dt, 0),
      ) as Vec3;
    let was = places(rope);
    let now = was;
    for (let time = 0; time < 0.3; time += dt) {
      was = now;
      w.step();
      now = places(rope);
    }
    close(momentum(was, now), [0.015, -0.1, 0], 1e-6);
    above(distance(now[3]!, [0.1, 0, 0]), 0.01);
    below(Math.hypot(...spin(marble)), 400);
  });

// ---- going back -------------------------------------------------------------------------------------------------------------

fact('put back to before, what lies between points goes on to the same bits', async () => {
  const w = await world();
  for (const x of [-0.2, 0.2]) addBar(w, [x, 0, 0]);
  const rope = addRope(w, line(10, 1, [-0.55, 0.05, 0], [1, 0, 0]), { radius: RADIUS });
  const marble = addBody(w, { mass: 0.02, position: [0.03, 0.6, 0], geometry: [sphere(0.01)] });
  const state = (): number[] => [...places(rope).flat(), ...position(marble), ...velocity(marble)];
  for (const before of [0.1, 0.25, 0.1, 0.5]) {
    w.advance(before);
    const snapshot = w.snapshot();
    w.advance(0.5);
    const first = state();
    w.restore(JSON.parse(JSON.stringify(snapshot)));
    w.advance(0.5);
    assert.deepEqual(state(), first, 'it goes on as it did');
    w.restore(snapshot);
  }
});
