import { createHash } from 'node:crypto';
import { readdirSync, readFileSync } from 'node:fs';

const ROOT = new URL('../../', import.meta.url);

/** Of all code in these folders and files. */
function hashOf(...paths: string[]): string {
  const hash = createHash('sha256');
  for (const path of paths) {
    const files = path.endsWith('/')
      ? (readdirSync(new URL(path, ROOT), { recursive: true }) as string[])
          .filter((name) => name.endsWith('.ts'))
          .map((name) => path + name)
      : [path];
    for (const file of files.sort()) hash.update(file).update(readFileSync(new URL(file, ROOT)));
  }
  return hash.digest('hex').slice(0, 16);
}

const PACKAGES = ['ammojs-typed', 'cannon-es', '@dimforge/rapier3d-compat', 'jolt-physics'];

const versionOf = (name: string): string => {
  const text = readFileSync(new URL(`node_modules/${name}/package.json`, ROOT), 'utf8');
  return (JSON.parse(text) as { version: string }).version;
};

/** What the result of any run hangs on: the cases, their references, how they are run, and the engines' versions. */
const ALL = [
  hashOf(...['lab/case.ts', 'lab/cases/', 'lab/engines/', 'lab/run/'], 'references/'),
  ...PACKAGES.map(versionOf),
].join('-');
const OURS = hashOf('physics-core/');

/** Stands for all code that a run of this engine goes through. */
export const sourcesOf = (engine: string): string =>
  ['ours', 'iterated'].includes(engine) ? `${ALL}-${OURS}` : ALL;
