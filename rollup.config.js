import { basename, dirname } from 'node:path';
import { globSync } from './tools/files.js';
import nodeResolve from '@rollup/plugin-node-resolve';
import { ammoModule } from './tools/build/engine/ammo-module.js';
import { brotli } from './tools/build/brotli.js';
import { inlineNumbers } from './tools/build/inline-numbers.js';
import { chunkBytes } from './tools/build/chunk-bytes.js';
import { cssText } from './tools/build/css-text.js';
import { banner, thirdParties } from './tools/build/licenses.js';
import { plainPairs } from './tools/build/plain-pairs.js';
import {
  copyWasm,
  minify,
  typescript,
  WASM_MODULE,
  wasmAsText,
  withoutDocs,
} from './tools/build/rollup-plugins.js';

const common = {
  // No module of Node either: bundlers for pages could not resolve it.
  plugins: [
    typescript(),
    withoutDocs(),
    plainPairs(),
    inlineNumbers(),
    cssText(),
    wasmAsText(),
    nodeResolve({ preferBuiltins: false }),
    ammoModule(),
    minify(),
    banner(),
    brotli(),
  ],
  onLog(level, log, handle) {
    // A bundle with an import that nobody can resolve is no bundle.
    if (log.code === 'UNRESOLVED_IMPORT') throw new Error(log.message);
    handle(level, log);
  },
};

const views = () => globSync('elements/ui/*/view.ts');

/** What only views need lies in their folder, so that it is whole: Ammo's glue is the only other package inside. */
const ofViews = (id) => /\/(elements\/ui|styles|node_modules(?!\/ammojs-typed))\//.test(id);

const OF_CORE =
  /\/physics-core\/(inside|face\/shown|solver\/tolerances|shapes\/(forms\/form|surface\/layout))\.ts$/;

/** What joints, contacts, hands, ropes, particles and soft things reckon with, each of them some of it. */
const OF_ARITHMETIC =
  /\/physics-core\/(base\/(cholesky|mix|exact\/(asin|expm1))|dynamics\/(inertia|other-end)|engine\/manifold-points|solver\/joints\/blocks)\.ts$/;

/** What reads, places and draws particles, and their tags. */
const OF_PARTICLES =
  /\/(elements\/(x3d-(particle-system|[a-z]+-emitter|[a-z]+-physics-model)|particles|bridge\/particles\/[\w-]+)|physics-core\/particles)\.ts$/;

/** What floats, with what waves have in common with that. */
const OF_FLOATING = /\/physics-core\/(effects\/water\/volume|world\/chunks\/water-code)\.ts$/;

/** The same of water. */
const OF_WATER =
  /\/(elements\/(x3d-water-volume|water|bridge\/water\/[\w-]+)|physics-core\/water)\.ts$/;

/** The same of ropes. */
const OF_ROPES =
  /\/(elements\/(x3d-(rope|soft-body-attachment)|ropes|bridge\/ropes\/[\w-]+)|physics-core\/ropes)\.ts$/;

/** The same of cloth and soft bodies. */
const OF_DEFORMABLES =
  /\/(elements\/(x3d-(cloth|soft-body)|deformables|bridge\/deformables\/[\w-]+)|physics-core\/deformables)\.ts$/;

/** What particles, ropes, cloth and soft bodies meet, and geometry as the triangles that they are laid on. */
const OF_OBSTACLES =
  /\/physics-core\/(effects\/particles\/collide\/[\w-]+|nodes\/particles\/mesh)\.ts$/;

/** What ropes, cloth and soft bodies have in common: that they are taken by hand. */
const OF_SOFT = /\/physics-core\/(nodes\/soft\/soft-node|effects\/drag\/soft-[\w-]+)\.ts$/;

/** What draws and takes Shapes for all of them. */
const OF_MATTER = /\/elements\/(soft-element|bridge\/matter\/[\w-]+)\.ts$/;

/** Winds and water push what they see of a body. */
const OF_SILHOUETTES =
  /\/physics-core\/(dynamics\/body-silhouette|shapes\/silhouette\/[\w-]+)\.ts$/;

/** What draws a world as lines, and who asks for it. */
const OF_DEBUG = /\/physics-core\/(debug-lines|effects\/debug-code)\.ts$/;

/**
 * What every page has comes in two files, however many elements it is written in: ours of the page, and the core, which
 * also runs without one. What debug drawing and measurement have in common with contacts stays in the file of these.
 */
const together = (id) => {
  if (OF_PARTICLES.test(id)) return 'particle-elements';
  if (OF_WATER.test(id)) return 'water-elements';
  if (OF_OBSTACLES.test(id)) return 'obstacles';
  if (OF_SOFT.test(id)) return 'soft-hands';
  if (OF_ROPES.test(id)) return 'rope-elements';
  if (OF_DEFORMABLES.test(id)) return 'deformable-elements';
  if (OF_MATTER.test(id)) return 'own-shapes';
  if (OF_FLOATING.test(id)) return 'water-code';
  if (OF_SILHOUETTES.test(id)) return 'silhouettes';
  if (/\/elements\/(x3d-[\w-]+|define|api|begin)\.ts$/.test(id)) return 'page';
  if (OF_ARITHMETIC.test(id)) return 'arithmetic';
  if (OF_CORE.test(id)) return 'core';
  if (OF_DEBUG.test(id)) return 'debug-code';
  return id.endsWith('/chunks/contact-code.ts') ? 'contact-code' : undefined;
};

/** One build for all modules, so that the page's entry, the core and each element share their chunks. */
const modules = (dir) => ({
  ...common,
  input: {
    'x3d-physics': 'elements/index.ts',
    core: 'physics-core/index.ts',
    ...Object.fromEntries(
      globSync('elements/x3d-*.ts').map((file) => [file.replace(/\.ts$/, ''), file]),
    ),
    // By names that do not change, for the classic scripts: elements/ui/monitor/view.ts is dist/ui/monitor.js.
    ...Object.fromEntries(views().map((file) => [`ui/${basename(dirname(file))}`, file])),
  },
  output: {
    dir,
    format: 'es',
    sourcemap: true,
    manualChunks: together,
    // The others flat beside ammo.wasm: `new URL('./ammo.wasm', import.meta.url)` holds in whichever chunk it lands.
    chunkFileNames: ({ moduleIds }) =>
      `${moduleIds.every(ofViews) ? 'ui/' : ''}chunk-[name]-[hash].js`,
  },
  plugins: [...common.plugins, copyWasm(), thirdParties(dir), chunkBytes(['x3d-physics', 'core'])],
});

/** The views of the ui are no part of the classic scripts, which load them from beside themselves. */
const classic = (input, file, ...external) => ({
  ...common,
  external: [/\/elements\/ui\/\w+\/view\.ts$/, ...external],
  input,
  output: {
    file,
    format: 'iife',
    name: 'X3DPhysics',
    inlineDynamicImports: true,
    sourcemap: true,
  },
});

/** Takes its time. */
const SLOW = ['minify', 'brotli'];

/** For pages that wait for it: the modules alone, as they are written. */
function quick(dir) {
  const { output, plugins, ...options } = modules(dir);
  return {
    ...options,
    plugins: plugins.filter(({ name }) => !SLOW.includes(name)),
    output: { ...output, sourcemap: false },
  };
}

const all = (dir) => [
  modules(dir),
  classic('elements/classic.ts', `${dir}/x3d-physics.classic.js`, WASM_MODULE),
  classic('elements/single.ts', `${dir}/x3d-physics.single.js`),
];

export default ({ configFolder = 'dist', configQuick }) =>
  configQuick ? quick(configFolder) : all(configFolder);
