import type { Cost } from './joints-cost.js';
import type { Endurance } from './joints-endurance.js';
import type { Dot, Way } from './joints-error.js';

/** What one run of the lab measured. */
export interface Results {
  date: string;
  machine: { cpu: string; cores: number; system: string; node: string };
  errors: Dot[];
  endurance: Endurance[];
  costs: Cost[];
}

const table = (head: readonly string[], rows: readonly (readonly string[])[]): string =>
  [head, head.map((_, i) => (i ? '---:' : '---')), ...rows]
    .map((cells) => `| ${cells.join(' | ')} |`)
    .join('\n');

const millimetres = (metres: number): string => String(Number((metres * 1e3).toPrecision(2)));
const percent = (share: number): string => `${Number((share * 100).toPrecision(2))} %`;

function errorTable(errors: readonly Dot[]): string {
  const ways: Way[] = ['with the joint solve', "Bullet's iterations alone"];
  const labels = [
    ...new Set(errors.filter(({ way }) => way === ways[0]).map(({ label }) => label)),
  ];
  const chains = [...new Set(errors.map(({ chain }) => chain))];
  const cell = (chain: string, label: string, of: Way): string => {
    const dot = errors.find((d) => d.chain === chain && d.label === label && d.way === of)!;
    return `${millimetres(dot.error)} (${dot.ms})`;
  };
  return table(
    ['level', ...chains.flatMap((chain) => [`${chain}, solve`, `${chain}, without`])],
    labels.map((label) => [
      label,
      ...chains.flatMap((chain) => ways.map((way) => cell(chain, label, way))),
    ]),
  );
}

const enduranceTable = (rows: readonly Endurance[]): string =>
  table(
    ['scene', 'level', 'solve', 'seconds', 'widest gap, of a link', 'all gaps, of the length'],
    rows.map(({ scene, level, solve, seconds, widest, sum }) => [
      scene,
      level,
      solve,
      String(seconds),
      percent(widest),
      percent(sum),
    ]),
  );

const costTable = (rows: readonly Cost[]): string =>
  table(
    ['shape', 'level', 'joints', 'solve, µs', 'Bullet, µs', 'ratio', 'whole step'],
    rows.map(({ shape, level, joints, solve, bullet, ratio, total }) => [
      shape,
      level,
      ...[joints, solve, bullet, ratio, total].map(String),
    ]),
  );

/** The part of the page between its two marks. */
export const tablesOf = ({ date, machine, errors, endurance, costs }: Results): string => `
## Measured

${date}, ${machine.cpu} (${machine.cores} cores), ${machine.system}, Node ${machine.node}.

Greatest error of the end in the first second, mm, and in brackets milliseconds of work per simulated second:

${errorTable(errors)}

Gaps at the worst moment:

${enduranceTable(endurance)}

Microseconds per joint and step, on trees, in the least disturbed turn: all that the solve does, and what Bullet's own rows
take, which is what its step takes longer than for the same bodies without joints. The ratio is the median over turns that both
took one after the other. Nothing touches these bodies, so with the solve Bullet's rows rest: the last column is a whole step
with the solve against one with Bullet's rows alone.

${costTable(costs)}
`;

const MARKS = ['<!-- tables -->', '<!-- end of tables -->'] as const;

/** The page with the tables of these results. */
export function withTables(page: string, results: Results): string {
  const [from, to] = MARKS.map((mark) => page.indexOf(mark)) as [number, number];
  return page.slice(0, from + MARKS[0].length) + '\n' + tablesOf(results) + '\n' + page.slice(to);
}
