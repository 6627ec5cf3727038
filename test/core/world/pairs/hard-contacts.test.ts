import assert from 'node:assert/strict';
import {
  addBody,
  addFloor,
  box,
  claim,
  codes,
  fact,
  height,
  position,
  told,
  world,
} from '../../helpers.js';
import type { World } from '../../../../physics-core/inside.js';

/** Boxes of a metre on each other. */
const pile = (w: World, masses: number[]) =>
  masses.map((mass, i) => addBody(w, { mass, position: [0, 0.5 + i, 0], geometry: [box(1)] }));

const LEVELS = ['game', 'standard', 'fine'] as const;

const SUNK = ['strong-gravity', 'sunk', 'mass-ratio'];

for (const accuracy of LEVELS)
  for (const [gravity, count] of [
    [1e4, 10],
    [1e4, 1],
    [1e5, 1],
  ] as const)
    fact(`at ${accuracy} and ${gravity} m/s², ${count} on a floor pass it not untold`, async () => {
      const w = await world({ accuracy, gravity: [0, -gravity, 0] });
      addFloor(w);
      const boxes = pile(w, Array<number>(count).fill(1));
      w.advance(1);
      const below = boxes.some((each) => height(each) < -0.5 && Math.abs(position(each)[0]) < 30);
      claim(w, ...SUNK.filter((code) => codes(w).includes(code)));
      assert.ok(!below || codes(w).some((code) => SUNK.includes(code)), 'below, and nothing said');
    });

for (const accuracy of LEVELS)
  for (const [what, masses] of [
    ['a ton on a gram', [1e-3, 1e3]],
    ['twelve decades of masses', Array.from({ length: 12 }, (_, i) => 10 ** (i - 6))],
  ] as const)
    fact(`at ${accuracy} ${what} are told of, once`, async () => {
      const w = await world({ accuracy });
      addFloor(w);
      pile(w, [...masses]);
      w.advance(1);
      claim(w, ...codes(w));
      assert.ok(told(w, 'mass-ratio').length > 0);
      assert.match(
        told(w, 'mass-ratio')[0]!,
        /weighs on .* contacts hold no more than 10000 times/,
      );
    });

fact('a gram on a ton, and a pile of like masses, are nothing to tell of', async () => {
  const w = await world();
  addFloor(w);
  pile(w, [1e3, 1e-3]);
  addBody(w, { position: [5, 0.5, 0], geometry: [box(1)] });
  addBody(w, { position: [5, 1.5, 0], mass: 50, geometry: [box(1)] });
  w.advance(1);
  assert.deepEqual(codes(w), []);
});
