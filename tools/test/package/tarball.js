// What is published: its licences, its size, and what tools that know packages say of it.
import assert from 'node:assert/strict';
import { existsSync, readdirSync, readFileSync, statSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { brotliDecompressSync } from 'node:zlib';
import { publint } from 'publint';
import { formatMessage } from 'publint/utils';
import { BIN, runNode } from '../../processes.js';
import { filesOf, packageOf, projectOf } from './entries.js';

/**
 * 2.6 MB. Most of it is Bullet, four times: as it is, packed by Brotli, as text for bundlers that copy no file, and in the
 * single script. What is packed by Brotli takes 510 kB, which no page loads besides: npm can't pack it any more.
 * Worlds in a worker take 26 kB: in the modules, in the classic script, which is their worker, and in the single one;
 * dense snapshots another 20, there too. Particle systems take 160, their types and descriptions included; 35 of them are
 * winds on bodies, and particles in workers and on the timeline. Water takes another 80, its waves half of them; ropes 100, cloth
 * and soft bodies 110; hands on those, water around them, links of ropes on thin things and recipes of all that 45. What other
 * libraries' pages cost and what public files do stays in the repository.
 */
const BYTES = 2_650_000;

const tarballOf = (application) =>
  join(
    application,
    readdirSync(application).find((name) => name.endsWith('.tgz')),
  );

const textOf = (application, file) => readFileSync(join(packageOf(application), file), 'utf8');

export function smallEnough(application) {
  const { size } = statSync(tarballOf(application));
  assert.ok(size < BYTES, `${size} bytes`);
}

/** What a server sends in the place of a file is that file. Small ones need none. */
export function packedFilesAreWhole(application) {
  const files = filesOf(application).filter((file) => file.endsWith('.br'));
  const read = (file) => readFileSync(join(packageOf(application), file));
  for (const file of files)
    assert.ok(brotliDecompressSync(read(file)).equals(read(file.slice(0, -3))), file);
  for (const file of ['ammo.wasm', 'x3d-physics.classic.js', 'core.js'])
    assert.ok(files.includes(`dist/${file}.br`) || read(`dist/${file}`).length < 1000, file);
}

/** What is bundled is not installed once more, and source maps are for whoever has the sources. */
export function nothingSuperfluous(application) {
  assert.equal(projectOf(application).dependencies, undefined);
  assert.deepEqual(
    filesOf(application).filter((file) => file.endsWith('.map')),
    [],
  );
}

const BUNDLED = ['Bullet', 'ammo.js', 'ammojs-typed', 'earcut', 'lit-html', 'robust-predicates'];

export function namesLicences(application) {
  const licences = textOf(application, 'dist/THIRD-PARTY-LICENSES.txt');
  for (const name of BUNDLED) assert.ok(licences.includes(name), `${name} is not named`);
  assert.ok(existsSync(join(packageOf(application), 'LICENSE')));
}

export function saysWhatItIs(application) {
  const { version, license } = projectOf(application);
  for (const build of ['x3d-physics', 'x3d-physics.classic', 'x3d-physics.single']) {
    const head = textOf(application, `dist/${build}.js`).slice(0, 100);
    assert.ok(head.includes(`x3d-physics ${version} | ${license}`), `${build} begins with ${head}`);
  }
}

/** Links of the README that stay in the package lead somewhere; there is no repository for them to lead to. */
export function linksLead(application) {
  // Pictures are shown by whoever has the repository.
  const links = [
    ...textOf(application, 'README.md').matchAll(/(?<!!\[[^\]]*)\]\((?!https:)([^)#]+)/g),
  ];
  assert.ok(links.length > 5);
  for (const [, link] of links)
    assert.ok(existsSync(join(packageOf(application), link)), `${link} is not in the package`);
}

export async function publintIsContent(application) {
  const pkgDir = packageOf(application);
  const { messages, pkg } = await publint({ pkgDir, pack: false, strict: true });
  const told = messages.map((message) => formatMessage(message, pkg, { color: false }));
  assert.deepEqual(told, []);
}

/** Scripts and the wasm have no types. */
const UNTYPED = ['x3d-physics.classic.js', 'x3d-physics.single.js', 'ammo.wasm'];

export async function typesAreRight(application) {
  const { ok, output } = await runNode(
    [
      ...[resolve(BIN.attw), tarballOf(application), '--profile', 'esm-only'],
      ...['--format', 'ascii', '--no-color', '--no-emoji'],
      ...['--exclude-entrypoints', ...UNTYPED],
    ],
    { quiet: true },
  );
  assert.ok(ok, output);
}
