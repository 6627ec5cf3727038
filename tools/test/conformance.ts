// npm run write -- conformance: runs every conformance fact in our library and in another X3D browser, and prints both columns.
//   --browser <name>   ours or x_ite; may be given more than once. Without it both
//   --only <word>      only facts whose node and field contain it, e.g. BallJoint or RigidBody.mass
//   --write            writes docs/conformance.md
import { readFileSync } from 'node:fs';
import { parseArgs } from 'node:util';
import { allTypes } from '../../physics-core/all-types.js';
import { factsOf } from '../../test/conformance/all.js';
import { openInCore } from '../../test/conformance/core-driver.js';
import type { Fact, Open } from '../../test/conformance/fact.js';
import { failures, judge, objections, type Judged } from '../../test/conformance/judge.js';
import { tells, XIte } from '../../test/conformance/x-ite-driver.js';
import { verdict, writeReport } from './conformance-report.js';

const { values: options } = parseArgs({
  options: {
    browser: { type: 'string', multiple: true },
    only: { type: 'string', default: '' },
    write: { type: 'boolean', default: false },
  },
});

export const OURS = 'x3d-physics';

/** One X3D browser. */
export interface Column {
  title: string;
  /** Its version, and what it runs in. */
  version: string;
  /** Whether it has the fields that the facts of a node ask for. */
  tells(node: string): boolean;
  open: Open;
  /** After a fact that could not be measured to its end. */
  renew(): Promise<void>;
  stop(): Promise<void>;
}

/** What every column measured of one fact. */
export interface Line {
  node: string;
  fact: Fact;
  judged: Judged[];
}

const readPackage = (): { version: string } => JSON.parse(readFileSync('package.json', 'utf8'));

const columns: Record<string, () => Promise<Column>> = {
  ours: async () => ({
    title: OURS,
    version: readPackage().version,
    tells: () => true,
    open: openInCore,
    renew: async () => {},
    stop: async () => {},
  }),
  x_ite: async () => {
    const xIte = await XIte.start();
    return {
      title: 'X_ITE',
      version: await xIte.version(),
      tells,
      open: xIte.open,
      renew: () => xIte.renew(),
      stop: () => xIte.stop(),
    };
  },
};

async function measure(node: string, fact: Fact, column: Column): Promise<Judged> {
  if (!column.tells(node)) return { fact, checks: [], pass: false, untold: true };
  try {
    const stage = await column.open(fact);
    const judged = await judge(fact, stage);
    await stage.close();
    if (judged.error) await column.renew();
    return judged;
  } catch (error) {
    await column.renew();
    return { fact, checks: [], pass: false, error: String((error as Error).message) };
  }
}

function print({ node, fact, judged }: Line, shown: Column[]): void {
  const marks = judged.map((each, i) => `${verdict(each)} ${shown[i]!.title}`);
  console.log(`${marks.join('  ')}  ${node}.${fact.field}: ${fact.says}`);
  judged.forEach((each, i) => {
    for (const failure of failures(each)) console.log(`      ${shown[i]!.title}: ${failure}`);
  });
}

async function main(): Promise<void> {
  // The core counts steps, not milliseconds.
  performance.now = () => 0;
  const start = Date.now();
  const names = options.browser ?? Object.keys(columns);
  for (const name of names)
    if (!columns[name]) throw new Error(`--browser knows ${Object.keys(columns).join(', ')}`);
  const shown: Column[] = [];
  for (const name of names) shown.push(await columns[name]!());
  const lines: Line[] = [];
  // The others are ours.
  const standard = Object.entries(factsOf).filter(([node]) => allTypes[node]!.clause);
  for (const [node, facts] of standard) {
    for (const fact of facts.filter(({ field }) => `${node}.${field}`.includes(options.only))) {
      const judged: Judged[] = [];
      for (const column of shown) judged.push(await measure(node, fact, column));
      lines.push({ node, fact, judged });
      print(lines.at(-1)!, shown);
    }
  }
  for (const column of shown) await column.stop();
  console.log(`\n${((Date.now() - start) / 1000).toFixed(1)} s`);
  shown.forEach(({ title, version }, i) => {
    const told = lines.map(({ judged }) => judged[i]!).filter(({ untold }) => !untold);
    const passed = told.filter(({ pass }) => pass).length;
    console.log(`${title} (${version}): ${passed} of ${told.length} facts`);
  });
  if (options.write) writeReport(lines, shown);
  const ours = shown.findIndex(({ title }) => title === OURS);
  const wrong = lines.filter(({ judged }) => ours >= 0 && objections(judged[ours]!).length > 0);
  process.exit(wrong.length === 0 ? 0 : 1);
}

await main();
