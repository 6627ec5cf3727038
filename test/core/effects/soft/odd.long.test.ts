import type { World } from '../../../../physics-core/inside.js';
import {
  addBody,
  addFloor,
  below,
  claim,
  close,
  distance,
  fact,
  position,
  sphere,
  world,
  type Node,
  type Vec3,
} from '../../helpers.js';
import { addRope, DOWN, line, place, places, tie } from './helpers.js';

/** m/s: nothing here falls, or is pulled, faster than that. */
const FAST = 60;

/** Goes on for so many steps; nothing of the ropes is ever nowhere, or faster than `FAST`. */
function goOn(w: World, ropes: readonly Node[], steps = 60): void {
  w.step();
  let before = ropes.map(places);
  for (let i = 0; i < steps; i++) {
    w.step();
    const now = ropes.map(places);
    now.forEach((points, r) => {
      points.forEach((at, n) => {
        below(distance(at, before[r]![n]!) / w.timeStep, FAST, `point ${n}, step ${i}`);
      });
    });
    before = now;
  }
}

// ---- lines that are none -----------------------------------------------------------------------------------------------

const LINES: Record<string, Vec3[]> = {
  'two equal points': [
    [0, 0, 0],
    [0, 0, 0],
  ],
  'three points, two of them equal': [
    [0, 0, 0],
    [0, 0, 0],
    [1, 0, 0],
  ],
  'all points equal': [
    [1, 1, 1],
    [1, 1, 1],
    [1, 1, 1],
    [1, 1, 1],
  ],
  'a line that goes back on itself': [
    [0, 0, 0],
    [1, 0, 0],
    [0, 0, 0],
    [1, 0, 0],
  ],
};

for (const [name, points] of Object.entries(LINES))
  fact(`${name}: whatever is held of it, it falls or hangs, and nothing is flung`, async () => {
    for (const fixedIndex of [[], [0], [0, points.length - 1]]) {
      const w = await world();
      goOn(w, [addRope(w, points, { fixedIndex })]);
    }
  });

fact('numbers that are none are told, and other ropes go on', async () => {
  for (const [x, code] of [
    [NaN, 'bad-value'],
    [Infinity, 'bad-value'],
    [1e20, 'out-of-range'],
  ] as const) {
    const w = await world();
    claim(w, 'bad-value', code);
    const good = addRope(w, line(4, 1, [5, 0, 0], DOWN), { fixedIndex: [0] });
    const bad = addRope(w, [
      [0, 0, 0],
      [x, 0, 0],
    ]);
    w.step(5);
    close(places(bad).length, 0, 0);
    close(place(good, 4), [5, -1, 0], 1e-6);
  }
});

// ---- fields ------------------------------------------------------------------------------------------------------------

const TOLD: Record<string, unknown[]> = {
  mass: [0, -1, 1e20],
  stretchStiffness: [-1, 1e20],
  bendStiffness: [-1, 1e20],
  damping: [-1, 1e20],
  friction: [-1, 1e20],
  radius: [-1, 1e20],
  segments: [-1],
  fixedIndex: [[-1]],
};

/** A rope level from a held end to a body, above a floor. */
function addLevel(w: World, fields: Record<string, unknown>): Node {
  addFloor(w, -3);
  const points = line(4, 1, [0, 0, 0], [1, 0, 0]);
  const rope = addRope(w, points, { radius: 0.01, fixedIndex: [0], ...fields });
  tie(w, rope, (fields.segments as number) || 4, {
    body: addBody(w, { position: [1, 0, 0], geometry: [sphere(0.1)] }),
  });
  return rope;
}

for (const [field, values] of Object.entries(TOLD))
  fact(`${field} beyond its range is told, and the rope is as without it`, async () => {
    const ends: Vec3[] = [];
    for (const value of values) {
      const w = await world();
      claim(w, 'out-of-range');
      const rope = addLevel(w, { [field]: value });
      goOn(w, [rope]);
      ends.push(place(rope, 4));
    }
    for (const end of ends) close(end, ends[0]!, 0);
  });

const STRANGE: Record<string, unknown[]> = {
  mass: [1e-20, 1e-6, 1e12],
  stretchStiffness: [1e-20, 1, 1e12],
  bendStiffness: [1e-20, 0.1],
  damping: [1e12],
  friction: [0, 1e12],
  radius: [0, 0.4],
  segments: [1, 1000],
  fixedIndex: [[0, 0, 0], [0, 1, 2, 3, 4], [4]],
};

for (const [field, values] of Object.entries(STRANGE))
  fact(`${field}, as strange as may be: nothing is flung`, async () => {
    for (const value of values) {
      const w = await world();
      goOn(w, [addLevel(w, { [field]: value })], 120);
    }
  });

fact('a rope of one point, or of none, is told and is not there', async () => {
  for (const points of [[], [[0, 0, 0]]] as Vec3[][]) {
    const w = await world();
    claim(w, 'bad-value');
    const rope = addRope(w, points);
    w.step(5);
    close(w.problems.length, 1, 0);
    close(places(rope).length, 0, 0);
  }
});

fact('an index beyond its points is told once, and the others hold', async () => {
  const w = await world();
  claim(w, 'out-of-range');
  const rope = addRope(w, line(4, 1, [0, 0, 0], DOWN), { fixedIndex: [99, 0] });
  w.step(20);
  close(w.problems.length, 1, 0);
  close(place(rope, 4), [0, -1, 0], 1e-6);
});

fact('what begins inside a body comes out of it, and is not thrown', async () => {
  const w = await world();
  addFloor(w);
  const rope = addRope(w, line(20, 2, [0, -0.2, 0], [1, 0, 0]), { radius: 0.02 });
  let most = 0;
  for (let i = 0; i < 360; i++) {
    w.step();
    most = Math.max(most, ...places(rope).map(([, y]) => y));
  }
  below(most, 0.3);
  for (const [, y] of places(rope)) close(y, 0.02, 1e-3);
});

fact('10,000 segments are many, and no more than that', async () => {
  const w = await world();
  const rope = addRope(w, line(1, 10, [0, 0, 0], DOWN), { segments: 10_000, fixedIndex: [0] });
  w.step(10);
  close(places(rope).length, 10_001, 0);
  close(place(rope, 10_000), [0, -10, 0], 1e-4);
});

// ---- ties --------------------------------------------------------------------------------------------------------------

fact('an attachment without a rope, or to a point that is none, holds nothing', async () => {
  const w = await world();
  claim(w, 'out-of-range');
  const body = addBody(w, { geometry: [sphere(0.1)] });
  w.add('SoftBodyAttachment', { body });
  const rope = addRope(w, line(4, 1, [5, 0, 0], DOWN));
  tie(w, rope, 99, { position: [0, 0, 0] });
  w.advance(1);
  close(position(body)[1], -4.9, 0.05);
  close(place(rope, 0)[1], -4.9, 0.05);
});

fact('two attachments of one point: it is held by one of them', async () => {
  const w = await world();
  const rope = addRope(w, line(4, 1, [0, 0, 0], DOWN), { damping: 1 });
  tie(w, rope, 0, { position: [0, 0, 0] });
  tie(w, rope, 0, { position: [0.5, 0, 0] });
  w.advance(2);
  const [x, y] = place(rope, 0);
  close([Math.abs(x - 0.25), y], [0.25, 0], 1e-6);
});

fact('a body that is removed lets go of its rope, and a rope of its bodies', async () => {
  const w = await world();
  const ropes = [0, 2].map((x) => addRope(w, line(4, 1, [x, 0, 0], DOWN), { fixedIndex: [0] }));
  const bodies = ropes.map((rope, i) => {
    const body = addBody(w, { position: [2 * i, -1, 0], geometry: [sphere(0.1)] });
    tie(w, rope, 4, { body });
    return body;
  });
  w.advance(0.5);
  bodies[0]!.remove();
  ropes[1]!.remove();
  goOn(w, [ropes[0]!], 120);
  close(place(ropes[0]!, 4), [0, -1, 0], 1e-6);
  close(position(bodies[1]!), [2, -1 - 4.9, 0], 0.15);
});

fact('an attachment that is removed lets go', async () => {
  const w = await world();
  const rope = addRope(w, line(4, 1, [0, 0, 0], DOWN));
  const body = addBody(w, { position: [0, -1, 0], geometry: [sphere(0.1)] });
  const [first, last] = [tie(w, rope, 0), tie(w, rope, 4, { body })];
  w.advance(0.5);
  close(position(body), [0, -1, 0], 1e-5);
  last.remove();
  w.advance(0.5);
  close(position(body)[1], -1 - 4.9 / 4, 0.05);
  close(place(rope, 4), [0, -1, 0], 1e-5);
  first.remove();
  w.advance(0.5);
  close(place(rope, 4)[1], -1 - 4.9 / 4, 0.05);
});

// ---- pins that are moved -----------------------------------------------------------------------------------------------

fact('points are held and let go as fixedIndex says meanwhile', async () => {
  const w = await world();
  const rope = addRope(w, line(10, 1, [0, 0, 0], [1, 0, 0]), { damping: 1 });
  for (const fixedIndex of [[0, 10], [0], [10], [5], [0, 5, 10], [], [3]]) {
    const before = places(rope);
    rope.set('fixedIndex', fixedIndex);
    goOn(w, [rope], 30);
    for (const i of fixedIndex) close(place(rope, i), before[i]!, 1e-9);
  }
});

fact('a pin that jumps 100 m takes its rope along, and that comes to rest there', async () => {
  const w = await world();
  const rope = addRope(w, line(10, 1, [0, 0, 0], DOWN), { damping: 2 });
  const pin = tie(w, rope, 0);
  w.step(10);
  pin.set('position', [100, 50, -30]);
  w.step(4);
  goOn(w, [rope], 120);
  w.advance(12);
  close(place(rope, 0), [100, 50, -30], 1e-9);
  close(place(rope, 10), [100, 49, -30], 1e-3);
});

fact('edits and removals in a step take hold in the next one', async () => {
  for (const event of ['beforestep', 'afterstep'] as const) {
    const w = await world();
    const rope = addRope(w, line(10, 1, [0, 0, 0], DOWN), { fixedIndex: [0] });
    const body = addBody(w, { position: [0, -1, 0], geometry: [sphere(0.1)] });
    const tied = tie(w, rope, 10, { body });
    let steps = 0;
    w.on(event, () => {
      steps++;
      if (steps === 5) rope.set('fixedIndex', [0, 5]);
      if (steps === 10) tied.set('index', 5);
      if (steps === 15) rope.set('points', line(6, 2, [0, 1, 0], DOWN));
      if (steps === 20) tied.remove();
      if (steps === 25) rope.remove();
    });
    w.step(40);
    close(places(rope).length, 7, 7);
    below(Math.hypot(...position(body)), 10);
  }
});
