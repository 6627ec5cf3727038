import { chainMasses } from '../../../../references/hanging-chain.js';
import type { World } from '../../../../physics-core/inside.js';
import {
  above,
  addBody,
  addFloor,
  addJoint,
  below,
  box,
  close,
  distance,
  fact,
  height,
  position,
  sphere,
  velocity,
  world,
  WEIGHTLESS,
  type Body,
  type Node,
  type Vec3,
} from '../../helpers.js';
import { addRope, DOWN, G, LEVELS, line, place, places, tie } from './helpers.js';

// ---- momentum ----------------------------------------------------------------------------------------------------------

const cross = ([a, b, c]: Vec3, [x, y, z]: Vec3): Vec3 => [
  b * z - c * y,
  c * x - a * z,
  a * y - b * x,
];

const sum = (parts: readonly (readonly number[])[]): number[] =>
  parts[0]!.map((_, k) => parts.reduce((all, part) => all + part[k]!, 0));

/** Linear and, about the origin, angular momentum of balls and of a rope as its last two places say. */
function momenta(
  w: World,
  bodies: readonly { body: Body; mass: number; inertia: number }[],
  [before, now]: readonly [Vec3[], Vec3[]],
  weights: readonly number[],
  placesBefore: readonly Vec3[],
): number[] {
  const parts = bodies.map(({ body, mass, inertia }, i) => {
    const p = velocity(body).map((v) => mass * v) as Vec3;
    const spin = (body.get('angularVelocity') as Vec3).map((v) => inertia * v);
    // Its velocity is of the middle of the step.
    const at = position(body).map((x, k) => (x + placesBefore[i]![k]!) / 2) as Vec3;
    return [...p, ...cross(at, p).map((l, k) => l + spin[k]!)];
  });
  now.forEach((at, i) => {
    const p = at.map((x, k) => (weights[i]! * (x - before[i]![k]!)) / w.timeStep) as Vec3;
    parts.push([...p, ...cross(at, p)]);
  });
  return sum(parts);
}

for (const accuracy of LEVELS)
  fact(`two balls on a rope keep their momentum in free flight, at ${accuracy}`, async () => {
    const w = await world({ accuracy, ...WEIGHTLESS });
    const points = line(10, 1, [-0.5, 0, 0], [1, 0, 0]);
    const rope = addRope(w, points, { mass: 0.5 });
    const bodies = [
      { at: 0, mass: 3, x: -0.5, linearVelocity: [0, 1, 0], angularVelocity: [0, 1, 2] },
      { at: 10, mass: 1, x: 0.5, linearVelocity: [0.3, 0.2, 1], angularVelocity: [1, 0, 0] },
    ].map(({ at, mass, x, ...moves }) => {
      const body = addBody(w, { mass, position: [x, 0, 0], geometry: [sphere(0.05)], ...moves });
      tie(w, rope, at, { body });
      return { body, mass, inertia: 0.4 * mass * 0.05 ** 2 };
    });
    const weights = chainMasses(10, 0.5);
    const next = (): number[] => {
      const [points, balls] = [places(rope), bodies.map(({ body }) => position(body))];
      w.step();
      return momenta(w, bodies, [points, places(rope)], weights, balls);
    };
    const start = next();
    const size = (of: readonly number[]): number => Math.hypot(...of);
    // Velocities of bodies are of single precision: in many short steps that is rounded often.
    const exact = { precise: 2e-6, reference: 4e-6 }[accuracy as string] ?? 1e-6;
    for (let i = 0; i < 2 / w.timeStep; i++) {
      const off = next().map((x, k) => x - start[k]!);
      below(size(off.slice(0, 3)) / size(start.slice(0, 3)), exact, 'linear');
      below(size(off.slice(3)) / size(start.slice(3)), 2 * exact, 'angular');
    }
  });

// ---- a box that is pulled ----------------------------------------------------------------------------------------------

for (const share of [0.5, 0.9, 1.1, 2])
  fact(`a box on a floor, pulled by a rope with ${share} of what friction holds`, async () => {
    const w = await world();
    addFloor(w);
    const held = addBody(w, { mass: 1, position: [0, 0.1, 0], geometry: [box(0.2)] });
    const puller = addBody(w, {
      mass: 1,
      position: [1.1, 0.1, 0],
      useGlobalGravity: false,
      geometry: [sphere(0.05)],
    });
    const rope = addRope(w, line(10, 1, [0.1, 0.1, 0], [1, 0, 0]), { mass: 1e-4 });
    tie(w, rope, 0, { body: held, position: [0.1, 0, 0] });
    tie(w, rope, 10, { body: puller });
    // What nobody says has a friction of 0.5.
    const bears = 0.5 * G;
    puller.set('forces', [[share * bears, 0, 0]]);
    w.advance(0.5);
    const [before, speed] = [position(held), velocity(held)[0]];
    w.advance(1);
    const speedsUp = Math.max(0, share - 1) * (bears / 2);
    if (share < 1) close(position(held), before, 1e-4);
    else close((velocity(held)[0] - speed) / speedsUp, 1, 0.01);
  });

// ---- what hangs on it --------------------------------------------------------------------------------------------------

for (const accuracy of LEVELS.filter((level) => level !== 'game'))
  for (const [middle, end] of [
    [1e-3, 1000],
    [1000, 1e-3],
  ] as const)
    fact(
      `${middle} kg halfway and ${end} kg at the end swing on one rope, at ${accuracy}`,
      async () => {
        const w = await world({ accuracy });
        const points = line(40, 2, [0, 0, 0], [1, 0, 0]);
        const rope = addRope(w, points, { fixedIndex: [0], mass: 0.1 });
        const bodies = [middle, end].map((mass, i) => {
          const body = addBody(w, { mass, position: [i + 1, 0, 0], geometry: [sphere(0.05)] });
          tie(w, rope, 20 * (i + 1), { body });
          return body;
        });
        const [heavy, far] = middle < end ? [bodies[1]!, 2] : [bodies[0]!, 1];
        for (let i = 0; i < 2 / w.timeStep; i++) {
          const before = height(heavy);
          w.step();
          const speed = Math.hypot(...velocity(heavy));
          // Its velocity is of the middle of the step.
          const energy = speed ** 2 / 2 + (G * (height(heavy) + before)) / 2;
          below(Math.abs(energy), 5e-3 * G * far, 'energy');
          below(Math.hypot(...position(heavy)), far + 2e-4, 'away');
          for (const body of bodies) below(Math.hypot(...velocity(body)), 30, 'speed');
        }
      },
    );

fact(
  'a heavy box on a rope, and a light one on a hinge below it, swing and keep their energy',
  async () => {
    const w = await world();
    const start = 0.5;
    const along: Vec3 = [Math.sin(start), -Math.cos(start), 0];
    const at = (far: number): Vec3 => along.map((x) => far * x) as Vec3;
    const sizes = [100, 1];
    const boxes = sizes.map((mass, i) =>
      addBody(w, {
        mass,
        position: at(1.1 + 0.3 * i),
        orientation: [0, 0, 1, start],
        geometry: [box(0.1, 0.2, 0.1)],
      }),
    );
    addJoint(w, 'SingleAxisHingeJoint', {
      body1: boxes[0],
      body2: boxes[1],
      anchorPoint: at(1.25),
      axis: [0, 0, 1],
    });
    const rope = addRope(w, line(20, 1, [0, 0, 0], along), { fixedIndex: [0], mass: 0.1 });
    tie(w, rope, 20, { body: boxes[0], position: [0, 0.1, 0] });
    // Without the rope, which is a thousandth of them.
    const energy = (before: readonly number[]): number =>
      boxes.reduce((all, body, i) => {
        const inertia = (sizes[i]! / 12) * (0.1 ** 2 + 0.2 ** 2);
        const turns = (body.get('angularVelocity') as Vec3)[2];
        const moves = Math.hypot(...velocity(body));
        const high = (height(body) + before[i]!) / 2;
        return all + (inertia * turns ** 2) / 2 + sizes[i]! * (moves ** 2 / 2 + G * high);
      }, 0);
    const first = energy(boxes.map(height));
    const swings = 100 * G * 1.1 * (1 - Math.cos(start));
    let widest = 0;
    for (let i = 0; i < 600; i++) {
      const before = boxes.map(height);
      w.step();
      close((energy(before) - first) / swings, 0, 5e-3, `step ${i}`);
      widest = Math.max(widest, -position(boxes[0]!)[0]);
    }
    above(widest / at(1.1)[0], 0.95);
  },
);

// ---- what carries it ---------------------------------------------------------------------------------------------------

/** A rope that hangs on a fixed box, by a corner of it. */
function hang(w: World): { post: Body; rope: Node } {
  const post = addBody(w, { fixed: true, geometry: [box(0.2)] });
  const rope = addRope(w, line(10, 1, [0.1, 0, 0], DOWN), { damping: 2 });
  tie(w, rope, 0, { body: post, position: [0.1, 0, 0] });
  return { post, rope };
}

fact('a fixed body that is carried along takes its rope with it', async () => {
  const w = await world();
  const { post, rope } = hang(w);
  for (let i = 1; i <= 120; i++) {
    post.set('position', [i / 120, 0, 0]);
    w.step();
    close(place(rope, 0), [0.1 + i / 120, 0, 0], 1e-6);
  }
  w.advance(12);
  close(place(rope, 10), [1.1, -1, 0], 1e-4);
});

fact('a fixed body that is turned turns the end of its rope', async () => {
  const w = await world();
  const { post, rope } = hang(w);
  for (let i = 1; i <= 120; i++) {
    post.set('orientation', [0, 0, 1, (Math.PI * i) / 120]);
    w.step();
  }
  close(place(rope, 0), [-0.1, 0, 0], 1e-5);
  w.advance(12);
  close(place(rope, 10), [-0.1, -1, 0], 1e-4);
});

fact('a fixed body that jumps 100 m takes its rope along, and flings nothing', async () => {
  const w = await world();
  const { post, rope } = hang(w);
  post.set('position', [100, 50, 0]);
  w.step(4);
  let before = places(rope);
  for (let i = 0; i < 240; i++) {
    w.step();
    const now = places(rope);
    now.forEach((at, n) => {
      below(distance(at, before[n]!) / w.timeStep, 30, `point ${n}, step ${i}`);
    });
    before = now;
  }
  w.advance(12);
  close(place(rope, 10), [100.1, 49, 0], 1e-4);
});

fact('a body that is fixed, and let go again, holds its rope and then hangs on it', async () => {
  const w = await world();
  const rope = addRope(w, line(10, 1, [0, 0, 0], DOWN), { fixedIndex: [0] });
  const body = addBody(w, { position: [0, -1, 0], geometry: [sphere(0.1)] });
  tie(w, rope, 10, { body });
  w.advance(0.2);
  body.set('fixed', true);
  rope.set('fixedIndex', []);
  w.advance(2);
  close(position(body), [0, -1, 0], 1e-5);
  above(-place(rope, 0)[1], 1.5);
  body.set('fixed', false);
  w.advance(1);
  close(height(body), -1 - G / 2, 0.1);
});
