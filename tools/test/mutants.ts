// npm run test:mutants: breaks one field's patch, one effect or one guard at a time and expects a test row that
// concerns it to throw. What survives is a promise that no test keeps.
//   --only <word>   only mutants whose name contains it
//   --facts         judged by the conformance facts alone
import { allEffects } from '../../physics-core/effects/all.js';
import { STAGES } from '../../physics-core/effects/effect/effect.js';
import assert from 'node:assert/strict';
import { parseArgs } from 'node:util';
import { guards } from '../../physics-core/base/guards.js';
import { energyGuards } from '../../physics-core/solver/energy/energy-guards.js';
import { allTypes } from '../../physics-core/all-types.js';
import { factsOf } from '../../test/conformance/all.js';
import { wrongInCore } from '../../test/conformance/core-driver.js';
import type { Fact } from '../../test/conformance/fact.js';
import { guardRows, lateRows, rowsOf } from '../../test/core/nodes/rows/all.js';
import type { Row } from '../../test/core/nodes/rows/row.js';
import { closeWorlds, world } from '../../test/core/helpers.js';

interface Mutant {
  name: string;
  rows: Row[];
  /** Breaks the code; returns how to mend it. */
  apply(): () => void;
}

const { values: options } = parseArgs({
  options: { only: { type: 'string' }, facts: { type: 'boolean', default: false } },
});

/** A conformance fact is one more row of its field. */
const asRow = (fact: Fact): Row => ({
  field: fact.field,
  fact: fact.says,
  run: async () => assert.deepEqual(await wrongInCore(fact), []),
});

const rowsAndFacts: Record<string, Row[]> = Object.fromEntries(
  Object.keys(allTypes).map((type) => [
    type,
    [...((!options.facts && rowsOf[type]) || []), ...(factsOf[type] ?? []).map(asRow)],
  ]),
);

const allRows = [...Object.values(rowsAndFacts).flat(), ...guardRows, ...lateRows];

/** Puts another function in the place of `object[key]`. */
function replacing(object: object, key: string, broken: unknown): () => () => void {
  return () => {
    const own = Object.getOwnPropertyDescriptor(object, key)!;
    Object.defineProperty(object, key, { ...own, value: broken });
    return () => Object.defineProperty(object, key, own);
  };
}

/** A field whose edit never reaches Bullet. */
const fieldMutants = (): Mutant[] =>
  Object.values(allTypes).flatMap((type) =>
    Object.entries(type.fields)
      .filter(([, field]) => field.patch)
      .map(([name, field]) => ({
        name: `${type.name}.${name} is not patched`,
        rows: rowsAndFacts[type.name]!.filter((row) => row.field === name),
        apply: replacing(field, 'patch', () => {}),
      })),
  );

/** A field whose edit does not make its object anew. */
const rebuildMutants = (): Mutant[] =>
  Object.values(allTypes).flatMap((type) =>
    Object.entries(type.fields)
      .filter(([, field]) => field.edit === 'rebuild')
      .map(([name, field]) => ({
        name: `${type.name}.${name} makes nothing anew`,
        rows: rowsAndFacts[type.name]!.filter((row) => row.field === name),
        apply: replacing(field, 'edit', 'passive'),
      })),
  );

/** An effect that does nothing in one stage of a step, at a contact, or when it looks ahead; or that nothing causes. */
async function effectMutants(): Promise<Mutant[]> {
  const { registry } = await world();
  closeWorlds(false);
  return allEffects.flatMap((descriptor) => {
    const { name } = descriptor;
    const rows = allRows.filter((row) => row.effect === name);
    const prototype = Object.getPrototypeOf(registry.get(descriptor)) as object;
    const hooks = [...STAGES, 'contact', 'look']
      .filter((method) => Object.hasOwn(prototype, method))
      .map((method) => ({
        name: `effect "${name}" without ${method}`,
        rows,
        // A contact that an effect does not look at goes on to the others.
        apply: replacing(prototype, method, () => true),
      }));
    if (!descriptor.found) return hooks;
    const apply = replacing(descriptor, 'found', () => {});
    return [...hooks, { name: `effect "${name}" is caused by no contact search`, rows, apply }];
  });
}

/** A guard that lets everything through. */
const open: Partial<Record<keyof typeof guards, unknown>> = {
  wellFormed: (_codec: unknown, value: unknown) => value,
  inRange: () => true,
  bounded: () => true,
  massive: () => true,
  finiteState: () => true,
  positive: () => true,
  torn: () => false,
  alike: () => true,
  roomy: () => true,
};

/** The other guards limit their first argument; those of energy say whether all is well. */
const guardMutants = (): Mutant[] => [
  ...opened(guards, (name) => open[name] ?? ((value: unknown) => value)),
  ...opened(energyGuards, () => () => true),
];

const opened = <T extends object>(of: T, wide: (name: keyof T) => unknown): Mutant[] =>
  (Object.keys(of) as (keyof T & string)[]).map((name) => ({
    name: `guard ${name} lets everything through`,
    rows: allRows.filter((row) => row.guard === name),
    apply: replacing(of, name, wide(name)),
  }));

/** Whether a row throws. */
async function fails(row: Row): Promise<boolean> {
  let judge = false;
  try {
    await row.run();
    judge = true;
    closeWorlds();
    return false;
  } catch {
    if (!judge) closeWorlds(false);
    return true;
  }
}

async function killed({ rows, apply }: Mutant): Promise<boolean> {
  const mend = apply();
  try {
    for (const row of rows) if (await fails(row)) return true;
    return false;
  } finally {
    mend();
  }
}

async function main(): Promise<void> {
  const start = Date.now();
  for (const row of allRows) {
    if (!(await fails(row))) continue;
    console.log(`✗ without any mutant a row fails: ${row.fact}\nRun the core tests first.`);
    process.exit(1);
  }
  const mutants = [
    ...fieldMutants(),
    ...rebuildMutants(),
    ...(await effectMutants()),
    ...guardMutants(),
  ].filter(({ name }) => name.includes(options.only ?? ''));
  const survivors: Mutant[] = [];
  for (const [i, mutant] of mutants.entries()) {
    const dead = await killed(mutant);
    if (!dead) survivors.push(mutant);
    console.log(`${dead ? '✓' : '✗'} ${i + 1}/${mutants.length} ${mutant.name}`);
  }
  if (survivors.length > 0) console.log('\nSurvivors:');
  for (const { name, rows } of survivors)
    console.log(`✗ ${name} (${rows.length === 0 ? 'no row concerns it' : `${rows.length} rows`})`);
  console.log(
    `\n${((Date.now() - start) / 1000).toFixed(1)} s\n${mutants.length - survivors.length} killed, ${survivors.length} survived`,
  );
  process.exit(survivors.length === 0 && mutants.length > 0 ? 0 : 1);
}

await main();
