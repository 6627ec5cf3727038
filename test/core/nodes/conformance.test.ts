import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { allTypes } from '../../../physics-core/all-types.js';
import { factsOf } from '../../conformance/all.js';
import { wrongInCore } from '../../conformance/core-driver.js';

// Tests count steps, not milliseconds: a busy machine must not make a frame drop any.
performance.now = () => 0;

for (const [type, facts] of Object.entries(factsOf)) {
  describe(`conformance of ${type}`, () => {
    for (const fact of facts) {
      test(`${fact.field}: ${fact.says}`, async () => {
        assert.deepEqual(await wrongInCore(fact), []);
      });
    }

    test('every field of its table has at least one fact, and every fact a field', () => {
      const fields = Object.entries(allTypes[type]!.fields)
        .filter(([, field]) => !field.own)
        .map(([name]) => name);
      const proved = new Set(facts.map(({ field }) => field));
      assert.deepEqual([...proved].sort(), fields.sort());
    });
  });
}

test('every node type has facts', () => {
  assert.deepEqual(Object.keys(factsOf).sort(), Object.keys(allTypes).sort());
});
