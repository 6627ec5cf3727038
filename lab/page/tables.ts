import { threeDigits } from '../draw/numbers.js';
import { BROWSER_NAMES } from '../draw/pages-chart.js';
import type { Table } from '../draw/table.js';
import type { Estimate } from '../statistics.js';
import { libraryOf } from './libraries/index.js';
import type { PageCell, PageNumbers } from './numbers.js';

/** Boxes at which the bound stands. */
const BOUND_AT = 500;

const shown = ({ median, low, high }: Estimate): string =>
  `${threeDigits(median)} (${threeDigits(low)} – ${threeDigits(high)})`;

const nameOf = (id: string): string => libraryOf(id).name;

/** Every side of the cells of that scene and browser. */
function rowsOf({ count, script, frames }: PageCell): string[][] {
  return Object.entries(script).map(([side, cost]) => {
    const rate = frames[side];
    const perSecond = rate && typeof rate !== 'string' ? threeDigits(rate.perSecond) : '–';
    if (typeof cost === 'string')
      return [`${count}, ${nameOf(side)}`, cost, '–', '–', '–', perSecond];
    const parts = side === 'ammo' ? ['–', '–'] : [shown(cost.physics), shown(cost.drawing)];
    return [
      `${count}, ${nameOf(side)}`,
      shown(cost.script),
      ...parts,
      cost.ours ? shown(cost.ours) : '–',
      perSecond,
    ];
  });
}

/** All that was measured of a scene in a browser. */
export const cellTable = (numbers: PageNumbers, browser: string, scene: string): Table => ({
  head: ['', 'script, ms', 'physics', 'drawing', 'our script to it', 'frames per second'],
  rows: numbers.browsers[browser]!.cells.filter((cell) => cell.scene === scene).flatMap(rowsOf),
});

/** How soon something moves, milliseconds. */
export function startTable({ browsers }: PageNumbers): Table {
  const names = Object.keys(browsers);
  const sides = [...new Set(names.flatMap((name) => Object.keys(browsers[name]!.start)))];
  return {
    head: ['ms to the first move', ...names.map((name) => BROWSER_NAMES[name]!)],
    rows: sides.map((side) => [
      nameOf(side),
      ...names.map((name) => {
        const ms = browsers[name]!.start[side];
        return ms === undefined ? '–' : typeof ms === 'string' ? ms : shown(ms);
      }),
    ]),
  };
}

/** Script of ours to that of others in the scene that the bound speaks of. */
export function ratioTable({ browsers }: PageNumbers): Table {
  const others = ['x-ite', 'a-frame', 'ammo'];
  return {
    head: [`${BOUND_AT} boxes`, ...others.map((side) => `our script to that of ${nameOf(side)}`)],
    rows: Object.entries(browsers).map(([name, { version, cells }]) => {
      const cell = cells.find(({ scene, count }) => scene === 'boxes' && count === BOUND_AT);
      const ratios = others.map((side) => {
        const cost = cell?.script[side];
        return cost && typeof cost !== 'string' && cost.ours ? shown(cost.ours) : '–';
      });
      return [`${BROWSER_NAMES[name]} ${version}`, ...ratios];
    }),
  };
}
