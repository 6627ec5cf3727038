import type { AskedPages } from '../../run/asked-browser.js';
import { MACHINE } from '../../run/machine.js';
import { WARM_UP } from '../measure.js';
import { asking } from '../pages.js';
import { FRAMES, measureCell } from './measure.js';
import { readThreads, writeThreads, type ThreadNumbers } from './numbers.js';
import { cellText } from './text.js';

function before(): ThreadNumbers['browsers'] {
  try {
    return readThreads().browsers;
  } catch {
    return {}; // None was measured yet.
  }
}

/** What is found is kept at once, in the place of what was found of that size before. */
export async function measureThreads(
  names: readonly string[],
  pages: AskedPages,
  counts: readonly number[],
): Promise<void> {
  const numbers: ThreadNumbers = { warmUp: WARM_UP, frames: FRAMES, browsers: before() };
  for (const name of names) {
    const found = (numbers.browsers[name] ??= { version: '', machine: '', cells: [] });
    for (const count of counts) {
      const { found: cell, version } = await asking(name, pages, (browser) =>
        measureCell(browser, count),
      );
      const others = found.cells.filter((one) => one.count !== count);
      found.cells = [...others, cell].sort((a, b) => a.count - b.count);
      Object.assign(found, { version, machine: MACHINE });
      process.stderr.write(`${cellText(name, cell)}\n`);
      writeThreads(numbers);
    }
  }
}
