import assert from 'node:assert/strict';
import { dot } from '../../../../physics-core/base/math.js';
import type { World } from '../../../../physics-core/inside.js';
import {
  above,
  addBody,
  addFloor,
  below,
  close,
  distance,
  fact,
  position,
  sphere,
  velocity,
  WEIGHTLESS,
  world,
  type Node,
  type Vec3,
} from '../../helpers.js';
import { addRope, LEVELS, places, tie } from './helpers.js';

const minus = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const clamp = (share: number): number => Math.min(1, Math.max(0, share));

/** How far apart two stretches are, and at which share of either (Ericson, Real-Time Collision Detection, 5.1.9). */
function apart(p: Vec3, p2: Vec3, q: Vec3, q2: Vec3): [far: number, s: number, t: number] {
  const [u, v, r] = [minus(p2, p), minus(q2, q), minus(p, q)];
  const [a, e, b, c, f] = [dot(u, u), dot(v, v), dot(u, v), dot(u, r), dot(v, r)];
  const across = a * e - b * b;
  let s = across > 1e-12 * a * e ? clamp((b * f - c * e) / across) : 0;
  let t = (b * s + f) / e;
  if (t < 0 || t > 1) {
    t = clamp(t);
    s = clamp((b * t - c) / a);
  }
  return [Math.hypot(...r.map((x, k) => x + s * u[k]! - t * v[k]!)), s, t];
}

/** How near a rope comes to itself, as a share of how thick it is; what is nearer along it, than a tight bend or what is said, is left out. */
function nearest(rope: Node, beyond?: number): number {
  const points = places(rope);
  const radius = rope.get('radius') as number;
  const along = [0];
  for (let i = 1; i < points.length; i++)
    along.push(along[i - 1]! + distance(points[i]!, points[i - 1]!));
  let least = Infinity;
  for (let i = 0; i + 1 < points.length; i++)
    for (let j = i + 1; j + 1 < points.length; j++) {
      const [far, s, t] = apart(points[i]!, points[i + 1]!, points[j]!, points[j + 1]!);
      const from = along[i]! + s * (along[i + 1]! - along[i]!);
      const to = along[j]! + t * (along[j + 1]! - along[j]!);
      if (to - from > (beyond ?? 1.02 * Math.PI * radius)) least = Math.min(least, far);
    }
  return least / (2 * radius);
}

/** The nearest that it came to itself in so many seconds. */
function nearestIn(w: World, rope: Node, seconds: number): number {
  let least = Infinity;
  for (let n = Math.round(seconds / w.timeStep); n > 0; n--) {
    w.step();
    least = Math.min(least, nearest(rope));
  }
  return least;
}

/** Turns of a rope 3 cm thick, one on the other, on the ground. */
const coil = (turns: number): Vec3[] =>
  Array.from({ length: 24 * turns + 1 }, (_, i): Vec3 => {
    const angle = (2 * Math.PI * i) / 24;
    return [0.12 * Math.cos(angle), 0.016 + 0.00126 * i, 0.12 * Math.sin(angle)];
  });

const COILED = { radius: 0.015, mass: 0.5, damping: 0.5, selfCollision: true };

for (const level of LEVELS.slice(0, 3))
  fact(`a coil of three turns lies as thick as it is, at ${level}`, async () => {
    const w = await world({ accuracy: level });
    addFloor(w);
    const rope = addRope(w, coil(3), COILED);
    above(nearestIn(w, rope, 1), 0.85, 'of its thickness');
    above(Math.max(...places(rope).map(([, y]) => y)), 0.06, 'm high');
  });

fact('without selfCollision the same coil lies flat on the ground', async () => {
  const w = await world();
  addFloor(w);
  const rope = addRope(w, coil(3), { ...COILED, selfCollision: false });
  w.advance(2);
  below(Math.max(...places(rope).map(([, y]) => y)), 0.03, 'm high');
});

fact('a coil of five turns comes to rest, and stays where it is', async () => {
  const w = await world({ rest: 'auto' });
  addFloor(w);
  const rope = addRope(w, coil(5), COILED);
  w.advance(6);
  const before = places(rope);

  w.advance(2);
  assert.deepEqual(places(rope), before);
});

/** Its first half is held, level; its second comes back and hangs over that, with its end as heavy as is said. */
const over = (): Vec3[] => {
  const points: Vec3[] = [];
  for (let i = 0; i <= 10; i++) points.push([-0.5 + 0.1 * i, 0, 0]);
  points.push([0.55, 0.15, 0.1], [0.5, 0.3, 0.2], [0.3, 0.3, 0.4], [0.1, 0.3, 0.4], [0, 0.3, 0.3]);
  for (let i = 1; i < 8; i++) points.push([0, 0.3, 0.3 - 0.1 * i]);
  return points;
};

const OVER = {
  radius: 0.02,
  friction: 1,
  damping: 1,
  selfCollision: true,
  fixedIndex: [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10],
};

for (const level of LEVELS.slice(0, 3))
  fact(`what falls over another part of it hangs there, at ${level}`, async () => {
    const w = await world({ accuracy: level });
    const rope = addRope(w, over(), OVER);
    above(nearestIn(w, rope, 1.5), 0.75, 'of its thickness');
  });

fact(
  'a rope 2 m long that falls on the ground from its end never goes through itself',
  async () => {
    const w = await world();
    addFloor(w);
    // Bends of a few millimetres, the same in every run.
    const points = Array.from({ length: 61 }, (_, i): Vec3 => [
      0.01 * Math.sin(1.7 * i),
      0.1 + 0.03 * i,
      0.01 * Math.cos(2.3 * i),
    ]);
    const rope = addRope(w, points, { ...COILED, damping: 1 });
    above(nearestIn(w, rope, 1.2), 0.1, 'of its thickness');
  },
);

// ---- what it keeps -----------------------------------------------------------------------------------------------------

/** Two arms of a rope that fly into each other, crosswise, and turn about where they are joined. */
function arms(w: World, fields: Record<string, unknown> = {}): Node {
  const points: Vec3[] = [];
  for (let i = 0; i <= 10; i++) points.push([0.05 * i, 0, 0.3 - 0.03 * i]);
  for (let i = 1; i <= 10; i++) points.push([0.5 - 0.05 * i, 0.1 * (i / 10), 0.03 * i]);
  return addRope(w, points, { radius: 0.02, selfCollision: true, ...fields });
}

fact('what it gives itself does not change its momentum', async () => {
  const w = await world(WEIGHTLESS);
  const rope = arms(w, { mass: 1 });
  const lengths = places(rope)
    .slice(1)
    .map((at, i) => distance(at, places(rope)[i]!));
  const whole = lengths.reduce((sum, each) => sum + each);
  const masses = places(rope).map(
    (_, i) => ((lengths[i - 1] ?? 0) + (lengths[i] ?? 0)) / 2 / whole,
  );
  // Its arms are flung at one another.
  const balls = [0, 20].map((index) => {
    // What has no shape meets nothing.
    const ball = addBody(w, { mass: 0.2, position: places(rope)[index]!, geometry: [] });
    tie(w, rope, index, { body: ball });
    return ball;
  });
  balls[0]!.set('linearVelocity', [0, 0.4, 0]);
  balls[1]!.set('linearVelocity', [0, -0.4, 0]);
  let least = Infinity;
  let before = places(rope);
  for (let n = 0; n < 240; n++) {
    w.step();
    const now = places(rope);
    const sum: Vec3 = [0, 0, 0];
    now.forEach((at, i) =>
      at.forEach((x, k) => (sum[k]! += (masses[i]! * (x - before[i]![k]!)) / w.timeStep)),
    );
    for (const ball of balls) velocity(ball).forEach((v, k) => (sum[k]! += 0.2 * v));
    for (const each of sum) close(each, 0, 1e-5, 'N s');
    before = now;
    least = Math.min(least, nearest(rope, 0.3));
  }
  below(least, 1.05, 'of its thickness: they met');
  above(least, 0.5, 'of its thickness');
});

fact('put back to before, it goes on to the same bits', async () => {
  const w = await world();
  addFloor(w);
  const rope = addRope(w, coil(2), COILED);
  const hung = addRope(
    w,
    over().map(([x, y, z]): Vec3 => [x + 2, y + 1, z]),
    OVER,
  );
  for (const before of [0.05, 0.2, 0.5]) {
    w.advance(before);
    const snapshot = w.snapshot();
    w.advance(0.3);
    const first = [places(rope), places(hung)];
    w.restore(JSON.parse(JSON.stringify(snapshot)));
    w.advance(0.3);
    assert.deepEqual([places(rope), places(hung)], first);
  }
});

// ---- edits and odd lines -------------------------------------------------------------------------------------------------

fact('told to meet itself where it lies within itself, it does not writhe', async () => {
  const w = await world();
  addFloor(w);
  const rope = addRope(w, coil(3), { ...COILED, selfCollision: false });
  w.advance(1);
  rope.set('selfCollision', true);
  let before = places(rope);
  for (let n = 0; n < 120; n++) {
    w.step();
    const now = places(rope);
    now.forEach((at, i) => below(distance(at, before[i]!) / w.timeStep, 0.5, 'm/s'));
    before = now;
  }
});

const ODD: Record<string, Vec3[]> = {
  'goes to and fro in one place': [
    [0, 0, 0],
    [1, 0, 0],
    [0, 0, 0],
    [1, 0, 0],
    [0, 0, 0],
  ],
  'has all points in one place': [
    [1, 1, 1],
    [1, 1, 1],
    [1, 1, 1],
    [1, 1, 1],
  ],
  'crosses itself': [
    [-1, 0, 0],
    [1, 0, 0],
    [1, 0, 1],
    [0, 0, 1],
    [0, 0, -1],
  ],
};

for (const [name, points] of Object.entries(ODD))
  for (const segments of [0, 40])
    fact(`a line that ${name}, in ${segments || 'its own'} links: nothing is flung`, async () => {
      const w = await world();
      addFloor(w, -1);
      const rope = addRope(w, points, { radius: 0.05, segments, selfCollision: true });
      let before = places(rope);
      for (let n = 0; n < 180; n++) {
        w.step();
        const now = places(rope);
        now.forEach((at, i) => below(distance(at, before[i]!) / w.timeStep, 30, 'm/s'));
        before = now;
      }
    });

fact('a knot drawn tight by twice what the rope weighs holds', async () => {
  const w = await world({ gravity: [0, -1, 0] });
  const points = Array.from({ length: 81 }, (_, i): Vec3 => {
    const t = -2.4 + 0.06 * i;
    return [0.05 * (t ** 3 - 3 * t), 1 - 0.05 * (t ** 4 - 4 * t * t), 0.05 * (t ** 5 / 5 - 2 * t)];
  });
  const rope = addRope(w, points, {
    radius: 0.012,
    mass: 0.5,
    damping: 4,
    segments: 120,
    fixedIndex: [0],
    selfCollision: true,
  });
  const ball = addBody(w, {
    mass: 1,
    position: points.at(-1)!,
    autoDamp: true,
    linearDampingFactor: 0.9999,
    geometry: [sphere(0.05)],
  });
  tie(w, rope, 120, { body: ball });
  above(nearestIn(w, rope, 7), 0.6, 'of its thickness');
  const length = 2.656;
  below(distance(position(ball), points[0]!), length - 0.2, 'm: the knot takes what is missing');
});
