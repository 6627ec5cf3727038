// Test files as they run: bundled, so that no page loads its 300 modules one by one and no process compiles TypeScript,
// and so that files which may run one after the other do so in one page or process.
import { readFileSync, rmSync, writeFileSync } from 'node:fs';
import { dirname } from 'node:path';
import { pathToFileURL } from 'node:url';
import { build } from 'esbuild';
import { glueToModule } from '../build/engine/ammo-module.js';
import { usedWasm } from '../build/engine/used-wasm.js';

/** Not a hidden folder: the test server would not serve it. */
const BUNDLES = 'test-bundles';

/** Tests and lab look into Bullet by calls that the core has no use for. */
const CALLERS = ['physics-core/**/*.ts', 'lab/**/*.ts', 'test/**/*.ts'];

/** Ammo for tests: what pages can't reach traps. */
export const wasmOfTests = () => usedWasm(CALLERS);

const ammoModule = {
  name: 'ammo-module',
  setup({ onLoad }) {
    onLoad({ filter: /ammo\.wasm\.js$/ }, ({ path }) => ({
      contents: glueToModule(readFileSync(path, 'utf8'), CALLERS),
    }));
  },
};

/** `import.meta.url` names the source: tests and lab read files that lie beside it. */
const sourceUrls = {
  name: 'source-urls',
  setup({ onLoad }) {
    onLoad({ filter: /[\\/](test|lab)[\\/].*\.ts$/ }, ({ path }) => ({
      loader: 'ts',
      contents: readFileSync(path, 'utf8').replaceAll(
        'import.meta.url',
        JSON.stringify(pathToFileURL(path).href),
      ),
    }));
  },
};

/** What only the build of the package makes, for pages that find no ammo.wasm. */
const NOT_BUILT = ['virtual:*'];

export const PLATFORMS = {
  /** Packages stay outside: they are loaded as in any program of Node. */
  node: {
    platform: 'node',
    target: 'node20',
    packages: 'external',
    external: NOT_BUILT,
    plugins: [sourceUrls],
    before: ['tools/test/take-turns.js'],
  },
  browser: {
    platform: 'browser',
    // What files have in common once for all of them, and what a scene may do without when it is needed.
    splitting: true,
    chunkNames: 'chunks/[name]-[hash]',
    target: 'es2022',
    // Lit's development build writes to the console.
    conditions: ['production'],
    loader: { '.css': 'text' },
    // The glue asks for Node's own modules in branches that a page never takes; the last ones come from the test server.
    external: [...NOT_BUILT, 'fs', 'path', '/__web-dev-server__*'],
    plugins: [ammoModule],
  },
};

/** Tests that need a process, or a page, in which nothing has run before; a page shows what takes long by itself, too. */
const ALONE = { node: /\.alone\.test\.ts$/, browser: /\.(alone|long)\.test\.ts$/ };

/**
 * Which files share a process or a page: the engine is loaded, and code compiled, once for all of them. By the bundle's
 * name; `nameOf` says where a file goes.
 */
function grouped(files, nameOf, alone) {
  const groups = {};
  for (const [i, file] of files.entries())
    (groups[alone.test(file) ? file : nameOf(file, i / files.length)] ??= []).push(file);
  return groups;
}

/** All of them together; those of a folder; in as many parts as let one see how far a browser is. */
export const TOGETHER = () => 'test/all.test.ts';
export const BY_FOLDER = (file) => file.replace(/\/[^/]+$/, '.test.ts');
const PARTS = 3;
export const IN_PARTS = (_, at) => `test/part-${1 + Math.floor(PARTS * at)}-of-${PARTS}.test.ts`;

/** Modules that import the files of a bundle, after what goes `before` them. */
const entries = (groups, before) => ({
  name: 'entries',
  setup({ onResolve, onLoad }) {
    const namespace = 'entries';
    onResolve({ filter: /\.test\.ts$/ }, ({ path, kind }) =>
      kind === 'entry-point' ? { path: path.replace(/^\.\//, ''), namespace } : undefined,
    );
    onLoad({ filter: /.*/, namespace }, ({ path }) => ({
      contents: [...before, ...groups[path]].map((file) => `import './${file}';`).join('\n'),
      resolveDir: process.cwd(),
    }));
  },
});

/** Of a bundle, the test file or files by their name. */
export const sourceOf = (bundle) => bundle.split('/').slice(2).join('/').replace(/\.js$/, '.ts');

/** Bundles the files for `platform`, as `nameOf` puts them together, into a folder of its own; answers where they lie. */
export async function bundleTests(files, { platform, stage, nameOf }) {
  const outdir = `${BUNDLES}/${stage}`;
  rmSync(outdir, { recursive: true, force: true });
  const { plugins, before = [], ...options } = PLATFORMS[platform];
  const groups = grouped(files, nameOf, ALONE[platform]);
  await build({
    ...options,
    plugins: [entries(groups, before), ...plugins],
    entryPoints: Object.keys(groups).map((name) => ({ in: name, out: name.replace(/\.ts$/, '') })),
    outdir,
    bundle: true,
    // `sideEffects` in package.json speaks of the built files.
    ignoreAnnotations: true,
    format: 'esm',
    sourcemap: true,
    tsconfig: 'tsconfig.json',
    logLevel: 'warning',
  });
  const bundles = Object.keys(groups).map((name) => `${outdir}/${name.replace(/\.ts$/, '.js')}`);
  if (platform === 'node') putWasmBeside(bundles);
  return bundles;
}

/** Where the core looks for it. */
function putWasmBeside(bundles) {
  for (const folder of new Set(bundles.map(dirname)))
    writeFileSync(`${folder}/ammo.wasm`, wasmOfTests());
}
