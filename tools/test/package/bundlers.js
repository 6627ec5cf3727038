// The package through bundlers, without any configuration.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { promisify } from 'node:util';
import nodeResolve from '@rollup/plugin-node-resolve';
import { build as esbuild } from 'esbuild';
import { rollup } from 'rollup';
import webpack from 'webpack';
import { folderOf, html } from './application.js';
import { came, falls, MAIN, measures, MODULE, PORT, served, site } from './pages.js';

/** What bundlers are given; a type's entry is nothing when it runs. */
const PROGRAM = `${MAIN}import 'x3d-physics/react';\n`;

const bundled = (application, name, script) =>
  site(application, name, html(script), { 'main.js': { text: PROGRAM } });

async function withEsbuild(folder, options) {
  const { warnings } = await esbuild({
    entryPoints: [join(folder, 'main.js')],
    outdir: join(folder, 'out'),
    bundle: true,
    logLevel: 'silent',
    ...options,
  });
  assert.deepEqual(warnings, []);
}

export async function esbuildScript(application, browser) {
  const folder = bundled(application, 'esbuild-script', '<script src="out/main.js"></script>');
  await withEsbuild(folder, {});
  await served(browser, folder);
}

export async function esbuildModules(application, browser) {
  const folder = bundled(application, 'esbuild-modules', MODULE.replace('main', 'out/main'));
  await withEsbuild(folder, { format: 'esm', splitting: true });
  const loaded = await served(browser, folder, measures(false));
  assert.ok(came(loaded, 'wasm-as-text'), 'the spare comes in place of ammo.wasm');
}

export async function rollupModules(application, browser) {
  const folder = bundled(application, 'rollup', MODULE.replace('main', 'out/main'));
  const bundle = await rollup({ input: join(folder, 'main.js'), plugins: [nodeResolve()] });
  await bundle.write({ dir: join(folder, 'out'), format: 'es' });
  await bundle.close();
  await served(browser, folder);
}

const VITE = { configFile: false, logLevel: 'silent' };
const viteSite = (application, name) =>
  folderOf(application, name, {
    'index.html': { text: html(MODULE) },
    'main.js': { text: PROGRAM },
    'public/x3dom.js': { from: join(application, 'node_modules/x3dom/x3dom.js') },
  });

/** Its server answers what it does not find with the page itself, in older versions. */
export const viteServer = (name, spare) => async (application, browser) => {
  const { createServer } = await import(name);
  const root = viteSite(application, `${name}-server`);
  const server = await createServer({ ...VITE, root, server: { port: PORT } });
  await server.listen();
  try {
    const loaded = await falls(browser, server.resolvedUrls.local[0]);
    assert.equal(came(loaded, 'wasm-as-text'), spare, 'the spare comes in place of ammo.wasm');
  } finally {
    await server.close();
  }
};

export const viteBuild = (name) => async (application, browser) => {
  const { build } = await import(name);
  const root = viteSite(application, `${name}-build`);
  await build({ ...VITE, root });
  const loaded = await served(browser, join(root, 'dist'), measures(true));
  assert.ok(!came(loaded, 'wasm-as-text'), 'ammo.wasm is found');
};

export async function webpackBuild(application, browser) {
  const folder = bundled(application, 'webpack', '<script src="out/main.js"></script>');
  const compiler = webpack({
    mode: 'production',
    context: folder,
    entry: './main.js',
    output: { path: join(folder, 'out'), publicPath: 'out/' },
    performance: { hints: false },
  });
  const stats = await promisify(compiler.run.bind(compiler))();
  assert.deepEqual(stats.toJson('errors-warnings').errors, []);
  assert.deepEqual(stats.toJson('errors-warnings').warnings, []);
  const loaded = await served(browser, folder, measures(true));
  assert.ok(!came(loaded, 'wasm-as-text'), 'ammo.wasm is found');
}

/** A worker of the page's own, with the core in it; the page shows how far a ball has fallen there. */
const WORKER = `import { createWorld } from 'x3d-physics/core';
const world = await createWorld();
const ball = world.add('RigidBody', { geometry: [{ type: 'Sphere', radius: 0.5 }] });
world.advance(1);
postMessage(ball.get('position')[1]);
`;
const ASKS = `${MAIN}globalThis.fromWorker = new Promise((resolve, reject) => {
  const worker = new Worker(new URL('./worker.js', import.meta.url), { type: 'module' });
  worker.onmessage = ({ data }) => resolve(data);
  worker.onerror = reject;
});
`;

async function fellInWorker(page) {
  const height = await page.evaluate(() => globalThis.fromWorker);
  assert.ok(Math.abs(height + 4.9) < 0.05, `in the worker the ball fell by ${height} m`);
}

export const viteWorker = (name) => async (application, browser) => {
  const { build } = await import(name);
  const root = folderOf(application, `${name}-worker`, {
    'index.html': { text: html(MODULE) },
    'main.js': { text: ASKS },
    'worker.js': { text: WORKER },
    'public/x3dom.js': { from: join(application, 'node_modules/x3dom/x3dom.js') },
  });
  await build({ ...VITE, root, worker: { format: 'es' }, build: { target: 'es2022' } });
  await served(browser, join(root, 'dist'), fellInWorker);
};
