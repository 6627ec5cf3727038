// Bundled for a worker of a page: asks for cells, runs them and tells what they found, until there are no more.
import { stabilityCases } from '../cases/index.js';
import { fromText, toText } from '../json.js';
import { runCell } from '../run.js';
import type { Asked } from './page.js';

async function run({ id, level }: Asked): Promise<string> {
  const which = stabilityCases.find((one) => one.id === id)!;
  return toText(await runCell(which, level));
}

async function main(): Promise<void> {
  for (;;) {
    const asked = fromText(await (await fetch('/next')).text()) as Asked;
    await fetch('/found', { method: 'POST', body: await run(asked) });
  }
}

void main();
