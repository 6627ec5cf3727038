import { levels, type LevelName } from '../../physics-core/inside.js';
import type { StabilityCase } from './case.js';
import { stabilityCases } from './cases/index.js';
import type { StabilityNumbers } from './numbers.js';
import { OTHERS } from './others.js';
import { criterionOf, promiseCount, signOf } from './table.js';

// What the matrix comes to, in words: the first thing that its page says.

const DEFAULT: LevelName = 'standard';

type Broken = readonly [which: StabilityCase, level: LevelName];

/** Cells that were looked at and break, promised or not. */
const brokenIn = ({ cells }: StabilityNumbers): Broken[] =>
  levels.flatMap(({ name: level }) =>
    stabilityCases
      .filter(({ id }) => cells[id]?.[level]?.holds === false)
      .map((which) => [which, level] as const),
  );

const sayBroken = ([which, level]: Broken, { cells }: StabilityNumbers): string =>
  `- at \`${level}\`, **${which.id}** (${which.says}): ${signOf(which, cells[which.id]![level])}, asked is ${criterionOf(which)}`;

/** How many of the cases that other engines can be told each of them holds. */
function besides({ cells, others }: StabilityNumbers): string {
  const told = Object.keys(others);
  const held = told.filter((id) => cells[id]?.[DEFAULT]?.holds).length;
  const theirs = OTHERS.map(({ engine, name }) => {
    const count = told.filter((id) => others[id]![engine.id]?.holds).length;
    return `${name} ${count}`;
  });
  return `Of the ${told.length} cases that other engines can be told, ${held} hold here at \`${DEFAULT}\`; with the same step, ${theirs.join(', ')}. Jolt leaves overlaps of up to two centimetres as they are by design, Rapier of one millimetre: where a millimetre is asked, a ✗ of a few may still stand.`;
}

/** What is looked at in the default level, and what is not and holds where it is. */
function counts({ cells }: StabilityNumbers): string {
  const seen = stabilityCases.filter(({ id }) => cells[id]?.[DEFAULT]);
  const held = seen.filter(({ id }) => cells[id]![DEFAULT]!.holds).length;
  const elsewhere = stabilityCases.length - seen.length;
  const all = held === seen.length ? `All ${held}` : `${held} of ${seen.length}`;
  return `**${all} hard cases that are looked at in \`${DEFAULT}\`, the default level, hold**; ${elsewhere} more are looked at in other levels alone.`;
}

export function verdictOf(numbers: StabilityNumbers): string {
  const { kept, broken: refuted } = promiseCount(numbers);
  const broken = brokenIn(numbers);
  const kind = refuted.length > 0 ? `these break: ${refuted.join(', ')}` : 'none breaks';
  return [
    `${counts(numbers)} Over all levels ${kept} cells are promised and hold; ${kind}.`,
    broken.length > 0
      ? `What breaks, and is promised at finer levels only:\n\n${broken.map((each) => sayBroken(each, numbers)).join('\n')}`
      : 'Nothing that was looked at breaks.',
    besides(numbers),
  ].join('\n\n');
}
