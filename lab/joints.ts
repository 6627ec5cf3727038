// npm run lab:joints: what the direct solve of joints gains and costs; writes docs/joints/ and the tables of its page.
//   --draw   measure nothing: charts and tables of the numbers of last time
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { cpus, platform, release } from 'node:os';
import { parseArgs } from 'node:util';
import { chartOf } from './joints-chart.js';
import { costs } from './joints-cost.js';
import { endurance } from './joints-endurance.js';
import { errorsAgainstTime } from './joints-error.js';
import { withTables, type Results } from './joints-page.js';

const { values: options } = parseArgs({ options: { draw: { type: 'boolean', default: false } } });

const FOLDER = new URL('../docs/joints/', import.meta.url);
const PAGE = new URL('../docs/joints.md', import.meta.url);
const NUMBERS = new URL('joints.json', FOLDER);

/** Numbers as people read them: three digits. */
function shown<Row extends object>(rows: readonly Row[]): Row[] {
  const short = (value: unknown): unknown =>
    typeof value === 'number' && !Number.isInteger(value) ? Number(value.toPrecision(3)) : value;
  const shortened = rows.map((row) =>
    Object.fromEntries(Object.entries(row).map(([key, value]) => [key, short(value)])),
  );
  console.table(shortened);
  return shortened as Row[];
}

const measured = async (): Promise<Results> => ({
  date: new Date().toISOString().slice(0, 10),
  machine: {
    cpu: cpus()[0]?.model ?? 'unknown',
    cores: cpus().length,
    system: `${platform()} ${release()}`,
    node: process.version,
  },
  errors: shown(await errorsAgainstTime()),
  endurance: shown(await endurance()),
  costs: shown(await costs()),
});

const csv = (rows: readonly object[]): string =>
  [Object.keys(rows[0]!), ...rows.map((row) => Object.values(row))]
    .map((cells) => `${cells.join(',')}\n`)
    .join('');

const results = options.draw
  ? (JSON.parse(readFileSync(NUMBERS, 'utf8')) as Results)
  : await measured();

mkdirSync(FOLDER, { recursive: true });
writeFileSync(NUMBERS, `${JSON.stringify(results, null, 2)}\n`);
for (const name of ['errors', 'endurance', 'costs'] as const)
  writeFileSync(new URL(`${name}.csv`, FOLDER), csv(results[name]));
for (const chain of new Set(results.errors.map((dot) => dot.chain))) {
  const dots = results.errors.filter((dot) => dot.chain === chain);
  const file = `chain-${chain.replaceAll(/[^a-z0-9]+/g, '-')}.svg`;
  writeFileSync(new URL(file, FOLDER), chartOf(chain, dots));
}
writeFileSync(PAGE, withTables(readFileSync(PAGE, 'utf8'), results));
