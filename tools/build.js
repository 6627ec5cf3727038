// npm run build: everything in dist/.
//   --no-types      without declarations, which take as long as all the rest
//   --quick <folder>  there, the modules alone, as they are written, in a few seconds
import { rmSync } from 'node:fs';
import { parseArgs } from 'node:util';
import { bundleDeclarations, DECLARATIONS } from './declarations.js';
import { BIN, runNode } from './processes.js';

const { values: options } = parseArgs({
  options: { 'no-types': { type: 'boolean' }, quick: { type: 'string' } },
});

async function must(name, promise) {
  const { ok, output } = await promise;
  if (ok) return;
  console.error(output);
  console.error(`build: ${name} failed`);
  process.exit(1);
}

const rollup = (...args) =>
  must('rollup', runNode([BIN.rollup, '-c', '--silent', ...args], { quiet: true }));

const manifest = (folder) =>
  must('manifest', runNode(['--import', 'tsx', 'tools/manifest.ts', folder], { quiet: true }));

async function everything() {
  await Promise.all([
    rollup(),
    options['no-types'] ||
      must('declarations', runNode([BIN.tsc7, '-p', 'tsconfig.types.json'], { quiet: true })),
  ]);
  if (!options['no-types']) await bundleDeclarations();
  rmSync(DECLARATIONS, { recursive: true, force: true });
  await manifest('dist');
}

const start = Date.now();
const folder = options.quick ?? 'dist';
// Old chunks carry another hash in their name and would stay for ever.
rmSync(folder, { recursive: true, force: true });
if (options.quick) await Promise.all([rollup('--configQuick', folder), manifest(folder)]);
else await everything();
console.log(`${folder}/ built in ${((Date.now() - start) / 1000).toFixed(1)} s`);
