import { writeFileSync } from 'node:fs';
import { effectsPicture } from '../draw/effects-chart.js';
import { threeDigits } from '../draw/numbers.js';
import { columnsOf } from '../draw/table.js';
import { MACHINE, today } from '../run/machine.js';
import { additions } from './additions.js';
import { Bytes } from './bytes.js';
import { costOf, PAIRS, TURN } from './measure.js';
import { readEffects, writeEffects, type EffectNumbers } from './numbers.js';
import { BODIES } from './scenes.js';

const PICTURE = new URL('../../docs/pictures/effects.svg', import.meta.url);

/** Measures what each effect adds; a line tells how far it is. */
export async function measureEffects(): Promise<void> {
  const bytes = await Bytes.read();
  const costs: EffectNumbers['costs'] = [];
  // The compiler's warm-up.
  await costOf(additions[0]!);
  for (const addition of additions) {
    process.stderr.write(`\r\x1b[K${costs.length + 1} of ${additions.length}: ${addition.effect}`);
    const cost = await costOf(addition);
    costs.push({ ...cost, bytes: bytes.of(addition.files, cost.chunk) });
  }
  process.stderr.write('\r\x1b[K');
  writeEffects({
    machine: MACHINE,
    date: today(),
    bodies: BODIES,
    pairs: PAIRS,
    turn: TURN,
    costs,
  });
}

/** Draws and prints the numbers of last time. */
export function showEffects(): void {
  const numbers = readEffects();
  writeFileSync(PICTURE, effectsPicture(numbers));
  const rows = numbers.costs.map(({ effect, by, without, ms, calls, chunk, bytes }) => [
    effect,
    ...[without, ms.median, ms.low, ms.high, calls, bytes / 1000].map(threeDigits),
    chunk ?? '–',
    by,
  ]);
  const head = ['effect', 'without', 'adds, ms', 'from', 'to', 'calls', 'kB', 'file', 'by'];
  console.log(
    `what each effect adds to a step of ${numbers.bodies} bodies, and to what a page fetches`,
  );
  console.log(columnsOf([head, ...rows], 1));
  console.log(
    'again: npm run build && npm run lab -- effects && npm run write -- effects; numbers: lab/report/effects.json',
  );
}
