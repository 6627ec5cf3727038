import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { parseAst } from 'rollup/parseAst';
import * as offsets from '../../physics-core/engine/offsets.js';
import * as tolerances from '../../physics-core/solver/tolerances.js';
import { inlineNumbers, numbersOf } from '../../tools/build/inline-numbers.js';

const FILE = 'physics-core/solver/tolerances.ts';
const numbers = numbersOf(readFileSync(FILE, 'utf8'));

/** A module of another room, as pages have it. */
const inlined = (code: string): string | undefined =>
  inlineNumbers().transform.call(
    { parse: parseAst },
    code,
    join(process.cwd(), 'physics-core/effects/a.ts'),
  )?.code;

test('a number stands where it is used, under the name that it has there', () => {
  assert.equal(
    inlined("import { BAND as b } from '../solver/tolerances.js';\nf(b);"),
    `const b = ${numbers.get('BAND')};\nf(b);`,
  );
});

test('so does a table of numbers, which a minifier knows then', () => {
  assert.equal(
    inlined("import { LEAF } from '../engine/offsets.js';\nf(LEAF.high);"),
    'const LEAF = {low:0,high:16,parent:32,proxy:36};\nf(LEAF.high);',
  );
});

test('what is no plain number is imported as before, and lines stay where they are', () => {
  assert.equal(
    inlined("import {\n  BAND,\n  SWAYING,\n} from '../solver/tolerances.js';\nf();"),
    `import { SWAYING } from '../solver/tolerances.js';const BAND = ${numbers.get('BAND')};\n\n\n\nf();`,
  );
});

test('what imports no such number is left alone', () => {
  assert.equal(inlined("import { show } from '../base/show.js';\nshow();"), undefined);
});

test('tables are those that the module exports', () => {
  const tables = numbersOf(readFileSync('physics-core/engine/offsets.ts', 'utf8'));
  assert.ok(tables.size > 15);
  for (const [name, text] of tables)
    assert.deepEqual(
      JSON.parse(text.replace(/\w+(?=:)/g, '"$&"').replace(',}', '}')),
      (offsets as Record<string, unknown>)[name],
      name,
    );
});

test('numbers are those that the module exports', () => {
  assert.ok(numbers.size > 50);
  for (const [name, text] of numbers)
    assert.equal(Number(text), (tolerances as Record<string, unknown>)[name], name);
});
