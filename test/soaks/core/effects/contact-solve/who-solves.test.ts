import assert from 'node:assert/strict';
import { contactSolve } from '../../../../../physics-core/effects/contact-solve/effects.js';
import { Newton } from '../../../../../physics-core/solver/methods/newton.js';
import type { Part } from '../../../../../physics-core/solver/part.js';
import type { World } from '../../../../../physics-core/inside.js';
import {
  above,
  addBody,
  addFloor,
  below,
  claim,
  box,
  fact,
  height,
  position,
  spin,
  velocity,
  world,
  type Body,
} from '../../../../core/helpers.js';
import {
  cards,
  farthest,
  pyramid,
  stack,
  standing,
  type Fields,
} from '../../../../core/effects/contact-solve/scenes.js';

// What is solved directly, what is left to Bullet's iterations, and that both come out the same each time.

/** How many bodies were solved directly in each step, and of those the most that hang together. */
function solvedIn(w: World, steps: number, most = false): number[] {
  const { prototype } = Newton;
  const own = Object.getOwnPropertyDescriptor(prototype, 'solve')!;
  const solve = own.value as (part: Part) => boolean;
  const counts: number[] = [];
  Object.defineProperty(prototype, 'solve', {
    ...own,
    value(this: Newton, part: Part) {
      const last = counts.length - 1;
      const { length } = part.bodies;
      counts[last] = most ? Math.max(counts[last]!, length) : counts[last]! + length;
      return solve.call(this, part);
    },
  });
  for (let i = 0; i < steps; i++) {
    counts.push(0);
    w.step();
  }
  Object.defineProperty(prototype, 'solve', own);
  return counts;
}

const isOn = (w: World): boolean =>
  w.effects.some(({ name, active }) => name === 'contact solve' && active);

fact(
  'where nothing touches there is no contact solve, and it is off when all has come apart',
  async () => {
    const w = await world();
    addFloor(w);
    const body = addBody(w, { position: [0, 3, 0] });
    w.advance(0.5);
    assert.equal(w.registry.find(contactSolve), undefined);
    body.event('position', [0, 0.5, 0]);
    w.advance(0.1);
    assert.ok(isOn(w));
    body.event('position', [0, 30, 0]);
    w.advance(0.1);
    assert.ok(!isOn(w));
  },
);

fact('it is off while its cause is gone, and on again with the next touch', async () => {
  const { w, bodies } = await standing(stack(2));
  w.step();
  assert.ok(isOn(w));
  for (const body of bodies) body.remove();
  w.step(2);
  assert.ok(!isOn(w));
  addBody(w, { position: [0, 0.5, 0], geometry: [box(1)] });
  w.step(2);
  assert.ok(isOn(w));
});

fact(
  'iterations that an author asks for are Bullet’s, and those he takes back are not',
  async () => {
    const scene = await standing(stack(10), { iterations: 10 });
    const { w } = scene;
    assert.deepEqual([...new Set(solvedIn(w, 60))], [0]);
    assert.ok(!isOn(w));
    above(farthest(scene, 5), 1e-3, 'm, as the iterations have it');
    w.settings.unset('iterations');
    w.advance(2);
    assert.ok(isOn(w));
    assert.deepEqual([...new Set(solvedIn(w, 60))], [10]);
    w.settings.set('iterations', 10);
    assert.deepEqual([...new Set(solvedIn(w, 60))], [0]);
    assert.ok(!isOn(w));
  },
);

const SPECIAL: [says: string, fields: Fields, problems?: string[]][] = [
  [
    'soft',
    { softnessConstantForceMix: 0.01, appliedParameters: ['CONSTANT_FORCE', 'ERROR_REDUCTION'] },
    ['approximated-field'],
  ],
  ['slipping', { slipFactors: [0.1, 0.1], appliedParameters: ['SLIP-1', 'SLIP-2'] }],
  [
    'of two frictions',
    { frictionCoefficients: [0.4, 0.1], appliedParameters: ['FRICTION_COEFFICIENT-2'] },
  ],
];

for (const [says, fields, problems = []] of SPECIAL)
  fact(
    `contacts that are ${says} are left to Bullet, with all that hangs together with them`,
    async () => {
      const w = await world();
      claim(w, ...problems);
      const shapes = [box(60, 1, 60), box(1)].map((shape) =>
        w.add('CollidableShape', { shape: [shape] }),
      );
      addBody(w, { fixed: true, position: [0, -0.5, 0], geometry: [shapes[0]] });
      addBody(w, { position: [0, 0.5, 0], geometry: [shapes[1]] });
      addBody(w, { position: [0, 1.5, 0], geometry: [box(1)] });
      for (const one of stack(3)) addBody(w, { ...one, position: [5, one.position[1]!, 0] });
      const collection = w.add('CollisionCollection', { collidables: shapes, ...fields });
      w.advance(0.5);
      assert.deepEqual([...new Set(solvedIn(w, 10))], [3], 'bodies apart from them');
      collection.set('appliedParameters', []);
      w.advance(0.5);
      assert.deepEqual([...new Set(solvedIn(w, 10))], [5], 'bodies, when it is over');
    },
  );

fact('many are solved while they are slow, and left to Bullet while they rush about', async () => {
  const { w, bodies } = await standing(pyramid(7));
  w.advance(0.2);
  assert.deepEqual(solvedIn(w, 3), [28, 28, 28]);
  for (const body of bodies) body.event('linearVelocity', [1, 0, 0]);
  below(Math.max(...solvedIn(w, 3, true)), 25, 'bodies that hang together and are solved');
  w.advance(1.5);
  assert.deepEqual(solvedIn(w, 3), [28, 28, 28]);
  below(Math.max(...bodies.map((body) => Math.hypot(...velocity(body)))), 1e-6, 'm/s');
});

// ---- the same each time ----------------------------------------------------------------------------------------------

const stateOf = (bodies: readonly Body[]): number[] =>
  bodies.flatMap((body) => [
    ...position(body),
    ...velocity(body),
    ...spin(body),
    ...(body.get('orientation') as number[]),
  ]);

/** A card house that a ball hits, and a stack. */
async function busy() {
  const scene = await standing([
    ...cards(),
    ...stack(8).map((one) => ({ ...one, position: [6, one.position[1]!, 0] })),
  ]);
  const { w, bodies } = scene;
  bodies.push(addBody(w, { position: [-3, 1.5, 0], linearVelocity: [4, 2, 0.5] }));
  return { w, bodies };
}

fact('the same steps come out the same, bit for bit, and so after reset', async () => {
  const runs: number[][] = [];
  for (let run = 0; run < 2; run++) {
    const { w, bodies } = await busy();
    w.step(120);
    runs.push(stateOf(bodies));
    w.reset();
    w.step(120);
    runs.push(stateOf(bodies));
  }
  for (const run of runs) assert.deepEqual(run, runs[0]);
});

fact('two restores of one snapshot run alike, bit for bit', async () => {
  const { w, bodies } = await busy();
  w.step(70);
  const kept = w.snapshot();
  const runs = [0, 1, 2].map((run) => {
    w.step(17 * run);
    w.restore(kept);
    w.step(60);
    return stateOf(bodies);
  });
  assert.deepEqual(runs[1], runs[0]);
  assert.deepEqual(runs[2], runs[0]);
});

fact('a stack that was restored stands as it stood', async () => {
  const scene = await standing(stack(10));
  scene.w.advance(1);
  const kept = scene.w.snapshot();
  scene.w.step(30);
  scene.w.restore(kept);
  below(farthest(scene, 5), 1e-3, 'm');
  below(Math.abs(height(scene.bodies[9]!) - 9.5), 1e-3, 'm');
});
