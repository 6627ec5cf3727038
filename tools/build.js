// npm run build: everything in dist/.
//   --no-types   without declarations, which take as long as all the rest
import { rmSync } from 'node:fs';
import { parseArgs } from 'node:util';
import { bundleDeclarations, DECLARATIONS } from './declarations.js';
import { BIN, runNode } from './processes.js';

const { values: options } = parseArgs({ options: { 'no-types': { type: 'boolean' } } });

async function must(name, promise) {
  const { ok, output } = await promise;
  if (ok) return;
  console.error(output);
  console.error(`build: ${name} failed`);
  process.exit(1);
}

const start = Date.now();
// Old chunks carry another hash in their name and would stay for ever.
rmSync('dist', { recursive: true, force: true });
await Promise.all([
  must('rollup', runNode([BIN.rollup, '-c', '--silent'], { quiet: true })),
  options['no-types'] ||
    must('declarations', runNode([BIN.tsc, '-p', 'tsconfig.types.json'], { quiet: true })),
]);
if (!options['no-types']) await bundleDeclarations();
rmSync(DECLARATIONS, { recursive: true, force: true });
await must('manifest', runNode(['--import', 'tsx', 'tools/manifest.ts'], { quiet: true }));
console.log(`dist/ built in ${((Date.now() - start) / 1000).toFixed(1)} s`);
