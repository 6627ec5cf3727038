// Test files as they run: bundled, so that no page loads its 300 modules one by one and no process
// compiles TypeScript. One build for all of them takes a second or two.
import { readFileSync, rmSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import { build } from 'esbuild';
import { glueToModule } from './engine/ammo-module.js';

/** Not a hidden folder: the test server would not serve it. */
const BUNDLES = 'test-bundles';

/** Tests look into Bullet by calls that the core has no use for. */
const CALLERS = ['physics-core/**/*.ts', 'test/**/*.ts'];

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

/** Bundles the files for `platform`; answers where they lie now. */
export async function bundleTests(files, platform) {
  const outdir = `${BUNDLES}/${platform}`;
  rmSync(outdir, { recursive: true, force: true });
  await build({
    ...PLATFORMS[platform],
    entryPoints: files,
    outdir,
    outbase: '.',
    bundle: true,
    // `sideEffects` in package.json speaks of the built files.
    ignoreAnnotations: true,
    format: 'esm',
    sourcemap: true,
    tsconfig: 'tsconfig.json',
    logLevel: 'warning',
  });
  return files.map((file) => `${outdir}/${file.replace(/\.ts$/, '.js')}`);
}
