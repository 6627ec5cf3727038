import assert from 'node:assert/strict';
import { levelNames } from '../../../../physics-core/dynamics/levels.js';
import type { World } from '../../../../physics-core/inside.js';
import {
  addBody,
  below,
  box,
  claim,
  close,
  fact,
  told,
  WEIGHTLESS,
  world,
  type Body,
} from '../../helpers.js';

// The ends of what is thin and turns fast strike what they pass.

const cylinder = (radius: number, height: number) => ({ type: 'Cylinder', radius, height });

/** A post along z. */
const addPost = (w: World, x: number, y = 0) =>
  addBody(w, {
    fixed: true,
    position: [x, y, 0],
    orientation: [1, 0, 0, Math.PI / 2],
    geometry: [cylinder(0.025, 1)],
  });

const rateOf = (body: Body): number => (body.get('angularVelocity') as number[])[2]!;

/** Turns by `angle` radians, and how fast it turns then. */
function turn(w: World, body: Body, angle: number): number {
  const steps = Math.ceil(angle / (rateOf(body) * w.timeStep));
  for (let i = 0; i < steps; i++) w.step(1);
  return rateOf(body);
}

for (const accuracy of levelNames)
  for (const rate of [5, 10, 20, 40, 60])
    fact(
      `the end of a rod of 2 cm that turns at ${rate} rad/s strikes a post, at ${accuracy}`,
      async () => {
        const w = await world({ ...WEIGHTLESS, accuracy });
        for (const before of [1, 1.05, 1.1]) {
          const z = 10 * before;
          const rod = addBody(w, {
            position: [0, 0, z],
            orientation: [0, 0, 1, -before],
            angularVelocity: [0, 0, rate],
            geometry: [box(2, 0.02, 0.02)],
          });
          const post = addPost(w, 0.9);
          post.set('position', [0.9, 0, z]);
          const about = (4 + 0.02 ** 2) / 12;
          // Nothing bounces: its struck point stands still.
          close(turn(w, rod, 1.5), (rate * about) / (about + 0.81), 0.1 * rate, 'rad/s');
          rod.remove();
          post.remove();
        }
      },
    );

fact('spokes, plates and hammers strike with what is far from their middle', async () => {
  const cross = [
    { type: 'Box', size: [2, 0.02, 0.1] },
    { type: 'Box', size: [0.02, 2, 0.1] },
  ];
  for (const geometry of [
    cross,
    [box(2, 0.02, 0.5)],
    [{ type: 'Cylinder', radius: 1, height: 0.02 }],
  ]) {
    const w = await world({ ...WEIGHTLESS, accuracy: 'game' });
    const isDisc = geometry[0]!.type === 'Cylinder';
    const body = addBody(w, {
      orientation: [0, 0, 1, -0.5],
      angularVelocity: [0, 0, 40],
      geometry,
    });
    addPost(w, isDisc ? 0.9 * Math.cos(0.5) : 0.9, isDisc ? 0 : 0);
    below(Math.abs(turn(w, body, 1.2)), 30, 'rad/s');
  }
});

/** How often a step was split: the parts of all steps in so many. */
function partsOf(w: World, steps: number): number {
  let parts = 0;
  for (let i = 0; i < steps; i++) {
    w.step(1);
    parts += Math.round(w.timeStep / w.partOfStep);
  }
  return parts;
}

fact(
  'what turns into itself, turns slowly or has nothing within reach splits no step',
  async () => {
    const rod = { geometry: [box(2, 0.02, 0.02)] };
    const fast = { angularVelocity: [0, 0, 40] };
    const scenes: ((w: World) => void)[] = [
      (w) => {
        addBody(w, { ...rod, ...fast });
        addPost(w, 3);
      },
      (w) => {
        addBody(w, { ...rod, angularVelocity: [0, 0, 0.5] });
        addPost(w, 0.9, 0.5);
      },
      (w) => {
        addBody(w, { geometry: [cylinder(0.5, 0.02)], angularVelocity: [0, 40, 0] });
        addPost(w, 0.6);
      },
      (w) => {
        addBody(w, { geometry: [box(2, 0.02, 0.02)], angularVelocity: [60, 0, 0] });
        addPost(w, 0.9, 0.5);
      },
      // What is as thick as that nothing passes through it.
      (w) => {
        addBody(w, { ...rod, ...fast });
        addBody(w, { fixed: true, position: [0, -2.5, 0], geometry: [box(5, 3, 5)] });
      },
    ];
    for (const [i, add] of scenes.entries()) {
      const w = await world({ ...WEIGHTLESS, accuracy: 'game' });
      add(w);
      assert.equal(partsOf(w, 10), 10, `scene ${i}`);
    }
  },
);

fact('ends that no part of a step can follow are told of, with the level that could', async () => {
  const w = await world({ ...WEIGHTLESS, accuracy: 'game' });
  addBody(w, { geometry: [box(2, 0.02, 0.02)], angularVelocity: [0, 0, 100] });
  addPost(w, -0.9, 0.3);
  claim(w, 'too-fast');
  w.step(1);
  assert.match(told(w, 'too-fast')[0]!, /ends that go 99 m\/s.*accuracy="standard"/);
});
