// npm run lab -- edits: whether one edit costs the same in a scene of 1000 bodies as in one of 10, interleaved in one run.
//   --rounds <n>   edits of each kind in each scene (400)
import { parseArgs } from 'node:util';
import { median } from '../run/median.js';
import { EDITS, LYING, scene, type Scene } from './scene.js';

const { values: options } = parseArgs({
  options: { rounds: { type: 'string', default: '400' } },
});
const ROUNDS = Number(options.rounds);
const SIZES = [10, 1000] as const;
/** Edits that are timed as one, since a clock of microseconds sees no single one. */
const BATCH = LYING;

/**
 * In a world at rest: it is timed by itself, and then everything comes to rest again. As far as we can tell,
 * three seconds of a thousand bodies leave little of an edit in the processor's caches, and those of ten leave much.
 */
const OUT_OF_REST = 'position, a jump out of rest';
const REST = 3;
const RESTED_ROUNDS = ROUNDS / 10;

function timedOutOfRest({ world, lying }: Scene, round: number): number {
  world.advance(REST);
  if (lying.some(({ sleeping }) => !sleeping)) throw new Error('a box does not rest');
  const start = performance.now();
  for (const [i, body] of lying.entries()) {
    body.set('position', [-8 - i, 0.25 + (round % 7) / 100, 0]);
    world.step(0);
  }
  return (performance.now() - start) / BATCH;
}

/** Milliseconds of some edits and of their way to Bullet. */
function timed(at: Scene, edit: (scene: Scene, i: number) => void, round: number): number {
  const start = performance.now();
  for (let i = 0; i < BATCH; i++) {
    edit(at, round * BATCH + i);
    at.world.step(0);
  }
  return (performance.now() - start) / BATCH;
}

type Time = (scene: Scene, round: number) => number;

function row(name: string, scenes: readonly Scene[], rounds: number, time: Time): string[] {
  const times: number[][] = scenes.map(() => []);
  for (let round = 0; round < rounds; round++)
    for (const [i, at] of scenes.entries()) times[i]!.push(time(at, round));
  const medians = times.map(median);
  const micro = medians.map((ms) => (ms * 1000).toFixed(1));
  return [name, ...micro, (medians[1]! / medians[0]!).toFixed(2)];
}

const scenes = await Promise.all(SIZES.map((size) => scene(size, 'never')));
const rested = await Promise.all(SIZES.map((size) => scene(size, 'auto')));
const rows = [
  ...Object.entries(EDITS).map(([name, edit]) =>
    row(name, scenes, ROUNDS, (at, round) => timed(at, edit, round)),
  ),
  row(OUT_OF_REST, rested, RESTED_ROUNDS, timedOutOfRest),
];

console.log('microseconds of one edit, medians of interleaved rounds\n');
console.log(`| edit | ${SIZES.map((size) => `${size} bodies`).join(' | ')} | ratio |`);
console.log('| --- | ---: | ---: | ---: |');
for (const cells of rows) console.log(`| ${cells.join(' | ')} |`);
