import assert from 'node:assert/strict';
import { test } from 'node:test';
import { RopeSolve } from '../../../../physics-core/solver/ropes/rope-solve.js';
import { FREE, HELD, Strand } from '../../../../physics-core/solver/ropes/strand.js';
import { below, random } from '../../helpers.js';

const DT = 1 / 120;
const G = 9.8;
const POINTS = 12;

/** A strand of .5 kg and 1.1 m that goes somewhere, its first and its last point held as said. */
function strandOf(first: number, last: number, seed: number): Strand {
  const strand = new Strand(POINTS);
  const next = random(seed);
  const some = (size: number): number => size * (2 * next() - 1);
  strand.lay(
    Array.from({ length: POINTS }, (_, i) => [0.1 * i, some(0.02), some(0.02)]).flat(),
    0.5,
  );
  strand.holders[0] = first;
  strand.holders[POINTS - 1] = last;
  for (let j = 0; j < 3 * POINTS; j++) strand.velocities[j] = some(0.2);
  return strand;
}

/** Begins a step as ropes do: velocities as they were, and what weight adds. */
function begin(strand: Strand): void {
  const { free, found, velocities, holders } = strand;
  strand.begin(DT);
  for (let j = 0; j < 3 * POINTS; j++) {
    free[j] = velocities[j]! - (j % 3 === 1 ? G * DT : 0);
    if (holders[Math.floor(j / 3)] === HELD) found[j] = velocities[j] = 0;
  }
}

/** N s that the momentum of each free point is off by after an even search, at most. */
function unbalanced({ masses, free, found, pulls, ways, changes, holders }: Strand): number {
  let most = 0;
  const push = (i: number, k: number): number => {
    if (i < 0 || i > POINTS - 2) return 0;
    const j = 3 * i + k;
    return pulls[i]! * (ways[j]! + (DT * (found[j + 3]! - found[j]!) - changes[j]!) / 4);
  };
  for (let i = 0; i < POINTS; i++)
    for (let k = 0; k < 3 && holders[i] === FREE; k++) {
      const own = masses[i]! * (free[3 * i + k]! - found[3 * i + k]!);
      most = Math.max(most, Math.abs(own + push(i, k) - push(i - 1, k)));
    }
  return most;
}

for (const [name, first, last] of [
  ['free', FREE, FREE],
  ['held at its last point', FREE, HELD],
  ['held at its first point', HELD, FREE],
  ['held at both', HELD, HELD],
] as const)
  test(`where even pulls are found each point gains what they give it: ${name}`, () => {
    for (const seed of [1, 2, 3]) {
      const strand = strandOf(first, last, seed);
      const solve = new RopeSolve();
      solve.take([strand], 0);
      let even = 0;
      for (let n = 0; n < 60; n++) {
        begin(strand);
        solve.solve(DT);
        if (solve.even) even++;
        if (solve.even) below(unbalanced(strand), 1e-9, `step ${n}`);
        strand.move(DT);
      }
      assert.ok(even > 30, `${even} even steps of 60`);
    }
  });
