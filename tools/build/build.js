// npm run build: everything in dist/.
//   --no-types      without declarations, which take as long as all the rest
//   --quick <folder>  there, the modules alone, as they are written, in a few seconds
import { renameSync, rmSync } from 'node:fs';
import { parseArgs } from 'node:util';
import { bundleDeclarations, declarationsIn } from './declarations.js';
import { BIN, runNode } from '../processes.js';

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
  must(
    'manifest',
    runNode(['--import', 'tsx', 'tools/build/manifest.ts', folder], { quiet: true }),
  );

const declarations = (folder) =>
  must(
    'declarations',
    runNode([BIN.tsc7, '-p', 'tsconfig.types.json', '--outDir', declarationsIn(folder)], {
      quiet: true,
    }),
  );

async function everything(folder) {
  const withTypes = !options['no-types'];
  await Promise.all([rollup('--configFolder', folder), withTypes && declarations(folder)]);
  if (withTypes) await bundleDeclarations(folder);
  rmSync(declarationsIn(folder), { recursive: true, force: true });
  await manifest(folder);
}

const quickly = (folder) =>
  Promise.all([rollup('--configFolder', folder, '--configQuick'), manifest(folder)]);

const start = Date.now();
const folder = options.quick ?? 'dist';
// It takes its folder's place when it is whole: a build that is ended leaves what was there. Old chunks, which carry
// another hash in their name, go with what they were part of.
const next = `${folder}-next`;
rmSync(next, { recursive: true, force: true });
await (options.quick ? quickly(next) : everything(next));
rmSync(folder, { recursive: true, force: true });
renameSync(next, folder);
console.log(`${folder}/ built in ${((Date.now() - start) / 1000).toFixed(1)} s`);
