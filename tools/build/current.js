// What is built anew, and what stands as it was built: by the contents of all that it is made of.
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import { globSync } from '../files.js';

/** Goes with the packages: what was built with others is built anew. */
export const CACHE = 'node_modules/.cache/x3d-physics';

const LIBRARY = [
  'physics-core/**/*.ts',
  'elements/**/*.ts',
  'styles/*',
  'types/*',
  'tools/build/**/*',
  'tools/*.js',
  '*.config.js',
  '*.json',
];

/** What each is made of, as patterns. */
const SOURCES = {
  library: LIBRARY,
  stories: [...LIBRARY, 'stories/**/*', '.storybook/*', 'lab/**/*', 'references/**/*.ts'],
};

/** Drawn from what lies beside it: no source. */
const isDrawn = (file) => /^lab\/report\/.*\.(html|csv)$/.test(file);

function fingerprint(name) {
  const hash = createHash('sha256');
  const files = SOURCES[name].flatMap(globSync).filter((file) => !isDrawn(file));
  for (const file of files)
    if (statSync(file).isFile()) hash.update(`${file}\n`).update(readFileSync(file));
  return hash.digest('hex');
}

const note = (name) => `${CACHE}/${name}.sha256`;

/** Has it made, unless it is there and of the same sources. False: it was. */
export async function keepCurrent(name, isThere, make) {
  const now = fingerprint(name);
  if (isThere() && existsSync(note(name)) && readFileSync(note(name), 'utf8') === now) return false;
  await make();
  mkdirSync(CACHE, { recursive: true });
  writeFileSync(note(name), now);
  return true;
}
