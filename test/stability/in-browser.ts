// node --import tsx test/stability/in-browser.ts firefox: each hard case at the lowest level that promises it, in a browser and
// beside it in Node. It holds there, too, and comes to the same bits. What takes long is left to the lab. With ids of cases
// behind the browser: these alone.
import { CellPage } from '../../lab/stability/browsers/page.js';
import type { Cell, StabilityCase } from '../../lab/stability/case.js';
import { stabilityCases } from '../../lab/stability/cases/index.js';
import { runCell } from '../../lab/stability/run.js';
import { wordsOf } from '../../lab/stability/table.js';

const [browser = 'chromium', ...ids] = process.argv.slice(2);

/** What is wrong, if anything. */
async function objection(page: CellPage, which: StabilityCase): Promise<string | undefined> {
  const level = which.promisedFrom!;
  let here: Cell;
  const there = await page.run({ id: which.id, level }, async () => {
    here = await runCell(which, level);
  });
  if (!there.holds) return wordsOf(which, there);
  if (there.bits !== here!.bits) return `${there.bits} and not ${here!.bits}, as in Node`;
}

const page = await CellPage.open(browser);
const chosen = stabilityCases.filter(({ id, promisedFrom, slow }) =>
  ids.length > 0 ? ids.includes(id) : promisedFrom && !slow,
);
let failed = 0;
for (const which of chosen) {
  const wrong = await objection(page, which);
  if (!wrong) continue;
  failed++;
  console.log(`${which.id} in ${browser}: ${wrong}`);
}
await page.close();
console.log(`${chosen.length - failed} passed, ${failed} failed`);
process.exit(failed > 0 ? 1 : 0);
