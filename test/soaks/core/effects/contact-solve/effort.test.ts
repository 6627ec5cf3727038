import assert from 'node:assert/strict';
import { Newton } from '../../../../../physics-core/solver/methods/newton.js';
import type { Part } from '../../../../../physics-core/solver/part.js';
import { levelNamed, type LevelName } from '../../../../../physics-core/dynamics/levels.js';
import type { World } from '../../../../../physics-core/inside.js';
import {
  addBody,
  addFloor,
  above,
  below,
  box,
  fact,
  position,
  random,
  velocity,
  world,
  type Body,
} from '../../../../core/helpers.js';

// What a step of a level spends on what touches and moves.

/** So many boxes, turned anyhow, above each other in a shaft 1 m wide. */
async function poured(count: number, accuracy: LevelName): Promise<{ w: World; boxes: Body[] }> {
  const w = await world({ accuracy });
  addFloor(w);
  for (const side of [-1, 1]) {
    addBody(w, { fixed: true, position: [side, 5, 0], geometry: [box(1, 40, 3)] });
    addBody(w, { fixed: true, position: [0, 5, side], geometry: [box(3, 40, 1)] });
  }
  const next = random();
  const boxes = Array.from({ length: count }, (_, i) =>
    addBody(w, {
      position: [0.2 * (next() - 0.5), 0.3 + 0.36 * i, 0.2 * (next() - 0.5)],
      orientation: [next(), next(), next(), 3 * next()],
      geometry: [box(0.2)],
    }),
  );
  return { w, boxes };
}

/** The blocks of what each step solves directly, while `act` runs. */
function blocksOfSteps(w: World, steps: number): number[] {
  const { solve } = Newton.prototype;
  const parts = new Set<Part>();
  Newton.prototype.solve = function (part, ...rest) {
    parts.add(part);
    return solve.call(this, part, ...rest);
  };
  try {
    return Array.from({ length: steps }, () => {
      parts.clear();
      w.step();
      return [...parts].reduce(
        (sum, { bodies, contacts }) => sum + bodies.length + contacts.length,
        0,
      );
    });
  } finally {
    Newton.prototype.solve = solve;
  }
}

fact(
  'a step of `game` solves directly no more blocks of what tumbles than its level says',
  async () => {
    const { effort } = levelNamed('game');
    const { w } = await poured(30, 'game');
    // Until the first of them lies.
    const blocks = blocksOfSteps(w, 36);
    above(Math.max(...blocks), 0);
    below(Math.max(...blocks), effort + 1);
  },
);

fact(
  'thirty boxes that tumble are left to Bullet at `standard`, and solved at `fine`',
  async () => {
    const { effort } = levelNamed('standard');
    const most = async (level: LevelName): Promise<number> => {
      const { w } = await poured(30, level);
      // Where nearly all of them are on each other, and none lies.
      w.step(Math.round(1.32 / w.timeStep));
      return Math.max(...blocksOfSteps(w, Math.round(0.16 / w.timeStep)));
    };
    below(await most('standard'), effort + 1);
    above(await most('fine'), 2 * effort);
  },
);

fact('a heap that lies is solved directly while something falls on it', async () => {
  const w = await world({ accuracy: 'game', rest: 'never' });
  addFloor(w);
  for (let i = 0; i < 20; i++) addBody(w, { position: [0, 0.5 + i, 0], geometry: [box(1)] });
  w.step(10);
  addBody(w, { position: [0, 20.6, 0], linearVelocity: [0, -1, 0], geometry: [box(1)] });
  above(Math.min(...blocksOfSteps(w, 12)), 2 * levelNamed('game').effort);
});

fact(
  'what tumbled at `game` lies in the end as still as at finer levels, and in nothing',
  async () => {
    const { w, boxes } = await poured(12, 'game');
    w.advance(10);
    for (const each of boxes) {
      below(Math.hypot(...velocity(each)), 1e-4);
      above(position(each)[1], 0.0999);
    }
  },
);

fact('each level tells its effort, which grows', async () => {
  const { levels } = await world();
  assert.deepEqual(
    levels.map(({ effort }) => effort),
    levels.map(({ effort }) => effort).toSorted((a, b) => a - b),
  );
  above(levels[0]!.effort, 0);
});
