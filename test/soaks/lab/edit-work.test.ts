// What one edit does in a scene of 1000 bodies and in one of 10, counted: V8 says how often each block of our code has run.
import assert from 'node:assert/strict';
import { Session } from 'node:inspector/promises';
import type { Scene } from '../../../lab/edits/scene.js';
import { below, fact } from '../../core/helpers.js';

const session = new Session();
session.connect();
await session.post('Profiler.enable');
await session.post('Profiler.startPreciseCoverage', { callCount: true, detailed: true });
// Only now: what was compiled before is counted by functions alone.
const { EDITS, scene } = await import('../../../lab/edits/scene.js');

const SIZES = [10, 1000] as const;
/** A plain loop over Bullet's pairs on the heap, 1.5 ns each: who rested on what jumps or goes. */
const SEARCH = 'eachTouching';

/** How often blocks of ours have run since this was last asked: those of the search, and all others. */
async function blocks(): Promise<{ search: number; other: number }> {
  const { result } = await session.post('Profiler.takePreciseCoverage');
  const ran = { search: 0, other: 0 };
  for (const { url, functions } of result) {
    if (!url.startsWith('file:') || url.includes('/node_modules/')) continue;
    for (const { functionName, ranges } of functions) {
      if (functionName === blocks.name) continue;
      for (const { count } of ranges) ran[functionName === SEARCH ? 'search' : 'other'] += count;
    }
  }
  return ran;
}

/** Blocks of the third of three edits alike: the first ones make what is kept. */
async function worked(at: Scene, edit: (at: Scene, i: number) => void, before?: () => void) {
  for (const i of [0, 1, 2]) {
    before?.();
    await blocks();
    edit(at, i);
    at.world.step(0);
  }
  return blocks();
}

async function isNoMore(
  small: Scene,
  large: Scene,
  work: (at: Scene) => ReturnType<typeof worked>,
) {
  const few = await work(small);
  const many = await work(large);
  assert.ok(few.other > 50, `only ${few.other} blocks were counted`);
  // Alike but for a few that V8 has compiled into others: one walk over the bodies would be ten times as many.
  below(many.other, 1.25 * few.other, 'blocks');
  // Up to three blocks for each of up to 1260 pairs.
  below(many.search, 3 * 1260, 'blocks of the search');
}

const [small, large] = await Promise.all(SIZES.map((size) => scene(size, 'never')));
for (const [name, edit] of Object.entries(EDITS))
  fact(
    `${name}: an edit does no more among 1000 bodies than among 10, but for the search through pairs`,
    () => isNoMore(small!, large!, (at) => worked(at, edit)),
  );

fact('nor does a jump out of rest, which searches nothing', async () => {
  const [few, many] = await Promise.all(SIZES.map((size) => scene(size, 'auto')));
  const jump = ({ lying }: Scene, i: number) => lying[0]!.set('position', [-8, 0.25 + i / 100, 0]);
  await isNoMore(few!, many!, async (at) => {
    const ran = await worked(at, jump, () => at.world.advance(3));
    assert.equal(ran.search, 0);
    return ran;
  });
});
