import { allEffects } from '../../../physics-core/effects/all.js';
import assert from 'node:assert/strict';
import { describe } from 'node:test';
import { guards } from '../../../physics-core/base/guards.js';
import { energyGuards } from '../../../physics-core/solver/energy/energy-guards.js';
import { allTypes } from '../../../physics-core/all-types.js';
import { factsOf } from '../../conformance/all.js';
import { fact, world } from '../helpers.js';
import { guardRows, lateRows, rowsOf } from './rows/all.js';

for (const [type, rows] of Object.entries(rowsOf)) {
  describe(type, () => {
    for (const row of rows) fact(`${row.field ?? row.effect}: ${row.fact}`, row.run);

    fact(
      'every field of its table has at least one row or conformance fact, and every row a field',
      () => {
        const fields = Object.keys(allTypes[type]!.fields);
        const proofs = [...rows, ...(factsOf[type] ?? [])];
        const covered = new Set(proofs.flatMap(({ field }) => field ?? []));
        assert.deepEqual([...covered].sort(), fields.sort());
      },
    );
  });
}

describe('effects of nodes that come in a chunk', () => {
  for (const row of lateRows) fact(`${row.effect}: ${row.fact}`, row.run);
});

describe('guards', () => {
  for (const row of guardRows) fact(`${row.guard}: ${row.fact}`, row.run);

  fact('every guard has at least one row', () => {
    const covered = new Set([...guardRows, ...Object.values(rowsOf).flat()].map((r) => r.guard));
    for (const guard of Object.keys({ ...guards, ...energyGuards }))
      assert.ok(covered.has(guard), guard);
  });
});

describe('tables', () => {
  fact('every node type has rows', () => {
    assert.deepEqual(Object.keys(rowsOf).sort(), Object.keys(allTypes).sort());
  });

  fact('every effect that works in the step has at least one row', async () => {
    const w = await world();
    const rows = [...Object.values(rowsOf).flat(), ...lateRows];
    const covered = new Set(rows.map((row) => row.effect));
    for (const descriptor of allEffects) {
      const effect = w.registry.get(descriptor);
      const works = effect.beforeStep || effect.afterStep || effect.contact;
      if (works) assert.ok(covered.has(descriptor.name), descriptor.name);
    }
  });
});
