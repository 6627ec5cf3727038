// npm run fuzz: random scenes with random edits, through the core's own words. Nothing may throw or hang, be other than
// finite, stay on the heap, or have energy that its author never gave. What fails is shrunk and printed with its seed.
//   --runs 10000   how many (1000)
//   --seed 7       of the first; the others follow it (1)
//   --edits        only edits of what hangs together and touches, while it runs
//   --look         recorded, and run anew from ever earlier moments: each has to be where it was
//   --sides        on both sides of a channel: steps taken on the other have to be the same bits
//   --back         snapshots in the middle of edits: each restore has to run as the world ran on
import { spawn } from 'node:child_process';
import { createInterface } from 'node:readline';
import { parseArgs } from 'node:util';

const { values } = parseArgs({
  options: {
    runs: { type: 'string', default: '1000' },
    seed: { type: 'string', default: '1' },
    edits: { type: 'boolean', default: false },
    back: { type: 'boolean', default: false },
    look: { type: 'boolean', default: false },
    sides: { type: 'boolean', default: false },
  },
});

const plans =
  (['back', 'look', 'sides', 'edits'] as const).find((kind) => values[kind]) ?? 'scenes';

/** A run hangs that takes so many seconds, shrinking included. */
const HANGS = 60;

/** Runs up to the last one that came to its end; the next seed after one that hung. */
function batch(first: number, runs: number): Promise<{ next: number; failed: number }> {
  const args = ['--import', 'tsx', 'test/fuzz/batch.ts', String(first), String(runs), plans];
  const child = spawn(process.execPath, args, { stdio: ['ignore', 'pipe', 'inherit'] });
  return new Promise((resolve) => {
    let [seed, failed, ended] = [first, 0, false];
    const hang = setTimeout(() => child.kill('SIGKILL'), HANGS * 1000);
    createInterface({ input: child.stdout }).on('line', (line) => {
      hang.refresh();
      if (line.startsWith('run ')) seed = Number(line.slice(4));
      else if (line === 'end') ended = true;
      else console.log(line);
      if (line.startsWith('✗')) failed++;
    });
    child.on('close', () => {
      clearTimeout(hang);
      if (!ended) console.log(`✗ seed ${seed}: it hangs, or ends the process`);
      resolve({ next: seed + 1, failed: failed + Number(!ended) });
    });
  });
}

const first = Number(values.seed);
const runs = Number(values.runs);
const end = first + runs;
let [seed, failed] = [first, 0];
while (seed < end) {
  const done = await batch(seed, end - seed);
  seed = done.next;
  failed += done.failed;
}
console.log(`seeds ${first} to ${end - 1}: ${runs - failed} passed, ${failed} failed`);
process.exit(failed > 0 ? 1 : 0);
