import assert from 'node:assert/strict';
import { test } from 'node:test';
import { DenseLu } from '../../../../physics-core/solver/matrix/dense-lu.js';
import { Elimination } from '../../../../physics-core/solver/ropes/elimination.js';
import {
  EVEN,
  Links,
  NEAREST,
  type Directions,
} from '../../../../physics-core/solver/ropes/links.js';
import { FREE, HELD, Strand } from '../../../../physics-core/solver/ropes/strand.js';
import { Touches } from '../../../../physics-core/solver/ropes/touches.js';
import { close, random } from '../../helpers.js';

const DT = 1 / 120;
const POINTS = 6;

/** Of the greatest number in what is compared. */
const EXACT = 1e-6;

/** A strand in the middle of a step, its links as long as they should be or nearly, all of them taut but those named. */
function strandOf(first: number, last: number, slack: readonly number[], seed: number): Strand {
  const strand = new Strand(POINTS);
  const next = random(seed);
  const some = (size: number): number => size * (2 * next() - 1);
  const line = Array.from({ length: POINTS }, (_, i) => [0.1 * i, some(0.03), some(0.03)]).flat();
  strand.lay(line, 0.6);
  strand.holders[0] = first;
  strand.holders[POINTS - 1] = last;
  for (let j = 0; j < 3 * POINTS; j++) {
    strand.velocities[j] = some(0.3);
    strand.free[j] = some(0.3);
    strand.found[j] = some(0.3);
  }
  for (let i = 0; i < POINTS - 1; i++) {
    strand.softness[i] = 1e-5;
    strand.pulls[i] = 1 + next();
    if (slack.includes(i)) {
      strand.pulls[i] = 0;
      strand.lengths[i]! += 1;
    }
  }
  strand.begin(DT);
  return strand;
}

/** What is missing of each momentum and each length, as velocities and pulls are. */
function missing(strand: Strand, links: Links, directions: Directions, taut: Uint8Array): number[] {
  const { masses, free, found, pulls, holders } = strand;
  const before = pulls.slice();
  links.read(DT, directions, false);
  pulls.set(before);
  const rest: number[] = [];
  for (let i = 0; i < POINTS; i++)
    for (let k = 0; k < 3; k++) {
      let r = holders[i] === FREE ? masses[i]! * (free[3 * i + k]! - found[3 * i + k]!) : 0;
      if (i < POINTS - 1 && taut[i]) r += pulls[i]! * links.pulling[3 * i + k]!;
      if (i > 0 && taut[i - 1]) r -= pulls[i - 1]! * links.pulling[3 * i - 3 + k]!;
      rest.push(r);
    }
  for (let i = 0; i < POINTS - 1; i++) rest.push(taut[i] ? links.excess[i]! : 0);
  return rest;
}

/** How all that depends on velocities and pulls, by small changes of each. */
function slopes(
  strand: Strand,
  links: Links,
  directions: Directions,
  taut: Uint8Array,
): number[][] {
  const of = (numbers: Float64Array, i: number, by: number): number[] => {
    const kept = numbers[i]!;
    numbers[i] = kept + by;
    const ahead = missing(strand, links, directions, taut);
    numbers[i] = kept - by;
    const behind = missing(strand, links, directions, taut);
    numbers[i] = kept;
    return ahead.map((r, n) => (r - behind[n]!) / (2 * by));
  };
  const columns = [...strand.found].map((_, j) => of(strand.found, j, 1e-5));
  for (let i = 0; i < POINTS - 1; i++) columns.push(of(strand.pulls, i, 1e-4));
  return columns;
}

/** Unknowns: velocities of free points, pulls of taut links. */
const unknowns = ({ holders }: Strand, taut: Uint8Array): number[] => [
  ...Array.from({ length: 3 * POINTS }, (_, j) => j).filter(
    (j) => holders[Math.floor(j / 3)] === FREE,
  ),
  ...Array.from(taut.keys()).flatMap((i) => (taut[i] ? [3 * POINTS + i] : [])),
];

/** Solves columns for right sides, over some of the numbers. */
function solved(
  columns: readonly number[][],
  over: readonly number[],
  right: readonly number[],
): number[] {
  const lu = new DenseLu();
  lu.resize(over.length);
  over.forEach((r, i) =>
    over.forEach((c, j) => (lu.matrix[i * over.length + j] = columns[c]![r]!)),
  );
  lu.factor();
  const out = Float64Array.from(over, (r) => right[r]!);
  lu.solve(out);
  return [...out];
}

/** What touches links between points pushes both, and resists both. */
function addTouches(between: Touches, right: number[], columns: number[][]): void {
  const { count, firsts, shares } = between.spots;
  for (let c = 0; c < count; c++) {
    if (!between.acts(c)) continue;
    const push = new Float64Array(3);
    const block = new Float64Array(9);
    between.press(c, 1, push, 0);
    between.resist(c, 1, block, 0, DT);
    const own = [1 - shares[c]!, shares[c]!];
    own.forEach((share, a) => {
      const i = 3 * (firsts[c]! + a);
      for (let r = 0; r < 3; r++) {
        right[i + r]! += share * push[r]!;
        own.forEach((other, b) => {
          const j = 3 * (firsts[c]! + b);
          for (let k = 0; k < 3; k++) columns[j + k]![i + r]! -= share * other * block[3 * r + k]!;
        });
      }
    });
  }
}

/** Something lies at such spots, presses and rubs, some of it slipping. */
function lay(strand: Strand, spots: readonly number[], seed: number): void {
  const { between } = strand;
  const next = random(seed);
  for (const c of spots) {
    between.touch(c);
    between.shares[c] = 0.1 + 0.8 * next();
    between.normals.set([0.6, 0.8, 0], 3 * c);
    between.gaps[c] = -0.001;
    between.presses[c] = between.pressed[c] = 0.1 + next();
    between.frictions[c] = c % 3;
    // So soft that the whole matrix can be solved to as many digits.
    between.yields[c] = 20 + 10 * next();
  }
}

const near = (actual: readonly number[], expected: readonly number[], what: string): void =>
  close(actual, expected, EXACT * Math.max(1e-9, ...expected.map(Math.abs)), what);

const ENDS = { free: FREE, held: HELD, tied: 0 };

for (const [name, directions] of Object.entries({ 'even pulls': EVEN, 'nearest places': NEAREST }))
  for (const [start, first] of Object.entries(ENDS))
    for (const [end, last] of Object.entries(ENDS))
      for (const [slack, spots] of [
        [[], []],
        [[2], []],
        [[0], []],
        [[4], []],
        [[], [0, 1, 4, 9]],
        [[2], [2, 4]],
        [[0], [0]],
        [[4], [7, 8]],
      ] as const)
        test(`one round of Newton is that of the whole matrix: ${name}, ${start} to ${end}, slack ${slack.join() || 'nowhere'}, touched at ${spots.join() || 'none'}`, () => {
          const strand = strandOf(first, last === 0 ? 1 : last, slack, 7);
          lay(strand, spots, 11);
          const links = new Links(strand);
          const knots = new Touches(strand, strand.knots);
          const between = new Touches(strand, strand.between);
          const elimination = new Elimination(strand, links, knots, between);
          links.begin(DT);
          knots.begin(DT);
          between.begin(DT);
          links.read(DT, directions, false);
          knots.read(DT, false);
          between.read(DT, false);
          const taut = links.taut.slice();
          assert.deepEqual(
            [...taut.keys()].filter((i) => !taut[i]),
            slack,
          );
          for (const c of spots) assert.ok(between.acts(c), `spot ${c} is touched`);
          elimination.fill(DT);
          const right = missing(strand, links, directions, taut);
          const columns = slopes(strand, links, directions, taut);
          addTouches(between, right, columns);
          links.read(DT, directions, false);
          elimination.reduce(0, POINTS - 1, DT);
          const inner = unknowns(strand, taut);

          // How tied ends are resisted, and what is missing there, once all else follows them.
          const tied = [0, POINTS - 1].filter((i) => strand.holders[i]! >= 0);
          const at = (i: number): number[] => [3 * i, 3 * i + 1, 3 * i + 2];
          const follows = (column: readonly number[]): number[] => solved(columns, inner, column);
          const left = follows(right);
          for (const i of tied) {
            const rests = at(i).map(
              (r) => right[r]! - inner.reduce((sum, c, n) => sum + columns[c]![r]! * left[n]!, 0),
            );
            const from = i === 0 ? 0 : 3;
            near([...elimination.endRests.slice(from, from + 3)], rests, `rest of ${i}`);
            for (const j of tied) {
              const block = at(j).map((c) => {
                const answer = follows(columns[c]!);
                return at(i).map(
                  (r) =>
                    columns[c]![r]! -
                    inner.reduce((sum, d, n) => sum + columns[d]![r]! * answer[n]!, 0),
                );
              });
              const start = (i === 0 ? 0 : 18) + (j === 0 ? 0 : 9);
              near(
                [...elimination.ends.slice(start, start + 9)],
                [0, 1, 2].flatMap((r) => [0, 1, 2].map((c) => -block[c]![r]!)),
                `block ${i} ${j}`,
              );
            }
          }

          // The changes of all, where the ends go on by something.
          const { change, pullChange } = elimination;
          change.fill(0);
          const goes = [0.02, -0.01, 0.03];
          for (const i of tied) at(i).forEach((j, k) => (change[j] = goes[k]! * (i + 1)));
          elimination.follow(0, POINTS - 1, DT);
          const pushed = right.map((r, n) =>
            tied.flatMap(at).reduce((sum, c) => sum + columns[c]![n]! * change[c]!, r),
          );
          const found = solved(columns, inner, pushed).map((x) => -x);
          const both = [...change, ...pullChange];
          near(
            inner.filter((j) => j < 3 * POINTS).map((j) => both[j]!),
            found.filter((_, n) => inner[n]! < 3 * POINTS),
            'velocities',
          );
          near(
            inner.filter((j) => j >= 3 * POINTS).map((j) => both[j]!),
            found.filter((_, n) => inner[n]! >= 3 * POINTS),
            'pulls',
          );
        });
