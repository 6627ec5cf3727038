import assert from 'node:assert/strict';
import { mkdirSync, rmSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { build } from 'esbuild';
// @ts-expect-error plain JavaScript
import { inSources } from '../../tools/test/source-positions.js';

const FOLDER = 'test-bundles/positions';

test('a position in a bundle is that in its source, and any other stays', async () => {
  mkdirSync(FOLDER, { recursive: true });
  writeFileSync(
    `${FOLDER}/a.ts`,
    '\ninterface A { a: 1 }\nexport const a: A = { a: 1 };\nthrow a;\n',
  );
  const outfile = `${FOLDER}/a.js`;
  await build({ entryPoints: [`${FOLDER}/a.ts`], outfile, sourcemap: true, format: 'esm' });
  const bundled = `at file://${process.cwd()}/${outfile}:2:1`;
  assert.equal(inSources(bundled), `at ${FOLDER}/a.ts:4:1`);
  assert.equal(inSources('at lab/run.ts:3:4'), 'at lab/run.ts:3:4');
  rmSync(FOLDER, { recursive: true });
});
