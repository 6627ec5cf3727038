import fc from 'fast-check';
// Particles come with it.
import '../../physics-core/index.js';
import { loadEngine } from '../../physics-core/create.js';
import { OwnedObjects } from './heap.js';
import { editsPlan } from './edits-plan.js';
import { playBack } from './back.js';
import { lookBack } from './looked-back.js';
import { plan } from './plan.js';
import { play } from './play.js';
import { playOnBothSides } from './sides.js';

// Some runs in one process; `run.ts` watches over it. Each run has a seed of its own.

/** Shrinking a failed run ends after so many milliseconds. */
const SHRINKING = 20_000;

const [first, runs] = process.argv.slice(2).map(Number) as [number, number];
const [, , , , kind] = process.argv;
const plans = { back: fc.oneof(editsPlan, plan), edits: editsPlan }[kind!] ?? plan;
const playOne = { back: playBack, look: lookBack, sides: playOnBothSides }[kind!] ?? play;

async function main(): Promise<void> {
  const owned = new OwnedObjects(await loadEngine());
  for (let seed = first; seed < first + runs; seed++) {
    process.stdout.write(`run ${seed}\n`);
    const failure = await failureOf(seed, owned);
    if (failure) process.stdout.write(`${failure}\n`);
  }
  process.stdout.write('end\n');
}

async function failureOf(seed: number, owned: OwnedObjects): Promise<string | undefined> {
  const found = await fc.check(
    fc.asyncProperty(plans, (one) => playOne(one, owned)),
    { seed, numRuns: 1, interruptAfterTimeLimit: SHRINKING },
  );
  if (!found.failed) return undefined;
  const why = found.errorInstance instanceof Error ? found.errorInstance.stack : 'interrupted';
  return `✗ seed ${seed}: ${why}\n${fc.stringify(found.counterexample?.[0])}`;
}

await main();
