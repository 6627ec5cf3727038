// x3dom's largest build, with the physics of its own, from x3dom's public source: no package registry has it. It is kept in
// no commit; the tests that need it are left out, visibly, where it is not there.
//   node tools/test/x3dom-full.js                      by git, from GitHub
//   X3DOM_SOURCE=../x3dom node tools/test/x3dom-full.js    from a folder that has the source
import { execFileSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const REPOSITORY = 'https://github.com/x3dom/x3dom.git';
const FOLDERS = ['build/core', 'src', 'lib'];
const OUT = 'x3dom-full';
const MINUTES = 60_000;

/** What its build joins, in that order, is a list in its source. */
function joined(source) {
  const packages = JSON.parse(readFileSync(join(source, 'build/core/packages.json'), 'utf8'));
  const files = ['BASIC', 'FULL', 'PHYSICS'].flatMap((name) =>
    Object.entries(packages[name]).flatMap(([folder, names]) =>
      names.map((file) => join(source, folder, file)),
    ),
  );
  return files.map((file) => readFileSync(file, 'utf8')).join('\n');
}

/** Of the newest commit, and only the folders that count. */
function clone(folder) {
  const git = (...args) => execFileSync('git', args, { stdio: 'ignore', timeout: 5 * MINUTES });
  git('clone', '--depth', '1', '--filter=blob:none', '--sparse', REPOSITORY, folder);
  git('-C', folder, 'sparse-checkout', 'set', ...FOLDERS);
  return folder;
}

const temporary = mkdtempSync(join(tmpdir(), 'x3dom-source-'));
try {
  const built = joined(process.env.X3DOM_SOURCE ?? clone(temporary));
  mkdirSync(OUT, { recursive: true });
  writeFileSync(join(OUT, 'x3dom-physics.js'), built);
  console.log(`${OUT}/x3dom-physics.js: ${(built.length / 1e6).toFixed(1)} MB`);
} catch (error) {
  console.log(`x3dom's source can't be had; its tests are left out: ${error.message}`);
} finally {
  rmSync(temporary, { recursive: true, force: true });
}
