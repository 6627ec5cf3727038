import { between } from '../draw/between.js';
import { threeDigits } from '../draw/numbers.js';
import { markdownOf } from '../draw/table.js';
import { others } from './engines.js';
import type { SoftNumbers } from './numbers.js';
import { asNear, besideTable, costTable, levelTable, missed, worse } from './tables.js';

/** More than this on each core, and others were at work. */
const BUSY = 1;

const list = (what: string, lines: readonly string[]): string =>
  lines.length === 0 ? `- ${what}: none.` : `- ${what}: ${lines.join('; ')}.`;

function conditionsOf({ cells }: SoftNumbers): string {
  const [first] = cells;
  const load = Math.max(...cells.map((cell) => cell.load));
  const busy = load > BUSY ? ' **The machine had other work beside.**' : '';
  return `${first!.date}, ${first!.machine}, a load of ${threeDigits(load)} on each core.${busy}`;
}

/** docs/soft.md with what these numbers say. */
export const withSoft = (text: string, numbers: SoftNumbers): string =>
  Object.entries({
    libraries: others
      .map(
        ({ id, name, package: by, says }) =>
          `- **${name}** (${by} ${numbers.versions[id]}): ${says}.`,
      )
      .join('\n'),
    beside: `${markdownOf(besideTable(numbers))}\n\n${others.map(({ id, name }) => list(`${name} as near as ours for no more`, asNear(numbers, id))).join('\n')}`,
    levels: `${markdownOf(levelTable(numbers))}\n\n${list('Misses its aim at `standard`', missed(numbers))}\n${list('A finer level further off than the one before', worse(numbers))}`,
    costs: `${markdownOf(costTable(numbers))}\n\n${conditionsOf(numbers)}`,
  }).reduce((now, [name, content]) => between(now, name, content), text);
