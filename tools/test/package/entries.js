// The package's entries as Node and TypeScript meet them.
import assert from 'node:assert/strict';
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { build } from 'esbuild';
import { matches } from '../../files.js';
import { BIN, runNode } from '../../processes.js';
import { folderOf } from './application.js';

export const packageOf = (application) => join(application, 'node_modules/x3d-physics');

/** All files of the package. */
export const filesOf = (application) =>
  readdirSync(packageOf(application), { recursive: true }).map((file) =>
    file.replaceAll('\\', '/'),
  );

/** Its package.json. */
export const projectOf = (application) =>
  JSON.parse(readFileSync(join(packageOf(application), 'package.json'), 'utf8'));

const exportsOf = (application) => projectOf(application).exports;

/** A program that Node runs in the application; what it prints. */
async function inNode(application, name, text) {
  const folder = folderOf(application, name, { 'program.js': { text } });
  const { ok, output } = await runNode(['program.js'], { cwd: folder, quiet: true });
  assert.ok(ok, output);
  return output;
}

/** Every address that `exports` answers is a file of the package. */
export function everyExportIsThere(application) {
  const files = filesOf(application);
  const targets = Object.values(exportsOf(application)).flatMap((target) =>
    typeof target === 'string' ? [target] : Object.values(target),
  );
  for (const target of targets) {
    const pattern = target.replace('./', '');
    assert.ok(
      files.some((file) => matches(file, pattern)),
      `${target} is not in the package`,
    );
  }
}

/** Where there is no page, importing does nothing. */
export async function everyModuleRunsInNode(application) {
  const elements = readdirSync(join(packageOf(application), 'dist/elements'))
    .filter((file) => file.endsWith('.js'))
    .map((file) => `./elements/${file}`);
  const modules = Object.entries(exportsOf(application))
    .filter(([name, { default: file }]) => file?.endsWith('.js') && !name.includes('*'))
    .map(([name]) => name);
  assert.ok(modules.includes('./react') && elements.length > 14);
  const imports = [...modules, ...elements, './elements/x3d-rigid-body'].map(
    (name) => `await import('${name.replace('.', 'x3d-physics')}');`,
  );
  await inNode(application, 'modules', imports.join('\n'));
}

const FALL = `
  import { createWorld } from 'x3d-physics/core';
  const world = await createWorld();
  const ball = world.add('RigidBody', { geometry: [{ type: 'Sphere', radius: 0.5 }] });
  world.advance(1);
  console.log(ball.get('position')[1]);`;

/** Half of g: what falls for a second. */
const assertFallen = (text) => assert.ok(Math.abs(Number(text) + 4.9) < 0.05, `fell to ${text}`);

export const coreRuns = async (application) =>
  assertFallen(await inNode(application, 'core', FALL));

const THREAD = `
  import { Worker, isMainThread } from 'node:worker_threads';
  if (isMainThread) new Worker(new URL(import.meta.url));
  else {${FALL.replace(/import (.*) from (.*);/, 'const $1 = await import($2);')}
  }`;

export const coreRunsInThread = async (application) =>
  assertFallen(await inNode(application, 'thread', THREAD));

/** The bundle has no ammo.wasm beside it. */
export async function coreRunsBundled(application) {
  const bundle = await build({
    stdin: { contents: FALL, resolveDir: application },
    platform: 'node',
    format: 'esm',
    bundle: true,
    write: false,
    logLevel: 'silent',
  });
  assertFallen(await inNode(application, 'core-bundled', bundle.outputFiles[0].text));
}

/** The addresses of Node's own modules, which no bundler for pages can resolve. */
export function noModuleOfNode(application) {
  for (const file of filesOf(application).filter((name) => /^dist\/.*\.js$/.test(name))) {
    const text = readFileSync(join(packageOf(application), file), 'utf8');
    const found = text.match(/(?:\bfrom|\bimport|\bimport\(|\brequire\()\s*["'`]node:[^"'`]*/);
    assert.ok(!found, `${file} has ${found}`);
  }
}

const STRICT = {
  target: 'es2022',
  module: 'esnext',
  moduleResolution: 'bundler',
  lib: ['es2023', 'dom', 'dom.iterable'],
  types: [],
  jsx: 'preserve',
  strict: true,
  skipLibCheck: true,
  noEmit: true,
};

/** Files of tools/test/package/types as one program. */
async function compile(application, name, files, options = {}) {
  const folder = folderOf(application, name, {
    ...Object.fromEntries(
      files.map((file) => [file, { from: join('tools/test/package/types', file) }]),
    ),
    'tsconfig.json': { text: JSON.stringify({ compilerOptions: { ...STRICT, ...options } }) },
  });
  const { ok, output } = await runNode([resolve(BIN.tsc), '-p', folder], { quiet: true });
  assert.ok(ok, output);
  for (const file of files) assert.ok(existsSync(join(folder, file)));
}

/** Each template takes our tags, and refuses an attribute that they do not have. */
export const everyTypeCompiles = (application) =>
  compile(application, 'types', readdirSync('tools/test/package/types'));

/** Neither a page nor another package's types are asked for, and the declarations themselves are checked. */
export const coreTypesStandAlone = (application) =>
  compile(application, 'core-types', ['core.ts'], {
    ...{ lib: ['es2023'], types: ['node'], skipLibCheck: false },
    ...{ module: 'nodenext', moduleResolution: 'nodenext' },
  });

/** It has its types without the rest of the package's. */
export const oneElementCompiles = (application) =>
  compile(application, 'element', ['element.ts'], { skipLibCheck: false });
