import { levels, type LevelName } from '../../../physics-core/inside.js';
import type { Table } from '../../draw/table.js';
import type { StabilityCase } from '../case.js';
import { stabilityCases } from '../cases/index.js';
import { promises } from '../levels.js';
import type { BrowserNumbers, StabilityNumbers } from '../numbers.js';
import { signOf } from '../table.js';

/** What a browser found in the promised cells of a case that it was asked for. */
interface Found {
  cells: number;
  holds: number;
  /** Cells that come to the bits that they have in Node. */
  alike: number;
}

const NOTHING: Found = { cells: 0, holds: 0, alike: 0 };

function foundOf(which: StabilityCase, numbers: StabilityNumbers, inIt: BrowserNumbers): Found {
  return levels.reduce((sum, { name }) => {
    const cell = inIt.cells[which.id]?.[name];
    if (!cell || !promises(which, name)) return sum;
    return {
      cells: sum.cells + 1,
      holds: sum.holds + Number(cell.holds),
      alike: sum.alike + Number(cell.bits === numbers.cells[which.id]?.[name]?.bits),
    };
  }, NOTHING);
}

const NAMES: Record<string, string> = {
  chromium: 'Chromium',
  firefox: 'Firefox',
  webkit: 'WebKitGTK, version',
};

/** A row each. */
export const inBrowsers = (numbers: StabilityNumbers): Table => ({
  head: ['browser', 'promised cells', 'hold', 'with the bits that they have in Node'],
  rows: Object.entries(numbers.browsers).map(([name, inIt]) => {
    const all = stabilityCases.map((which) => foundOf(which, numbers, inIt));
    const sum = (key: keyof Found) => `${all.reduce((total, found) => total + found[key], 0)}`;
    const title = `${NAMES[name]} ${inIt.version}, ${inIt.date}`;
    return [title, sum('cells'), sum('holds'), sum('alike')];
  }),
});

/** What one of them comes to, and in which of them. */
interface Elsewhere {
  words: string;
  browsers: string[];
}

/** By what they come to: where all agree, that is one. */
function elsewhereOf(which: StabilityCase, level: LevelName, numbers: StabilityNumbers) {
  const found = new Map<string, Elsewhere>();
  for (const [name, { cells }] of Object.entries(numbers.browsers)) {
    const cell = cells[which.id]?.[level];
    if (!cell || !promises(which, level)) continue;
    if (cell.holds && cell.bits === numbers.cells[which.id]?.[level]?.bits) continue;
    const words = signOf(which, cell);
    const there = found.get(words) ?? { words, browsers: [] };
    there.browsers.push(name);
    found.set(words, there);
  }
  return [...found.values()];
}

/** The promised cells that browsers bring to other bits than Node, or that break there. */
export const besidesNode = (numbers: StabilityNumbers): Table => ({
  head: ['case', 'level', 'in Node', 'in browsers', 'which'],
  rows: stabilityCases.flatMap((which) =>
    levels.flatMap(({ name: level }) =>
      elsewhereOf(which, level, numbers).map(({ words, browsers }) => [
        which.id,
        level,
        signOf(which, numbers.cells[which.id]?.[level]),
        words,
        browsers.length === Object.keys(numbers.browsers).length ? 'all' : browsers.join(', '),
      ]),
    ),
  ),
});
