// npm start: installs what is missing and serves the documentation from its sources, with a library that is bundled in
// seconds; behind it, what pages load and the stories are built, where anything changed.
import { existsSync, renameSync, rmSync } from 'node:fs';
import { CACHE, keepCurrent } from '../build/current.js';
import { endWithStarters } from '../endings.js';
import { ensurePackages } from '../build/install.js';
import { runNode } from '../processes.js';

const PORT = 6006;

const seconds = (since) => `${((Date.now() - since) / 1000).toFixed(0)} s`;

/** Says what is done, and how long it took. */
async function tell(what, act) {
  const start = Date.now();
  process.stdout.write(`${what} … `);
  const made = await act();
  console.log(made === false ? 'nothing has changed' : seconds(start));
}

async function serveSources(library) {
  // Only now: they import packages.
  const { gather, serveLive } = await import('./site.js');
  await tell('Gathering the pages', () => gather(library));
  return serveLive(PORT);
}

async function build(...args) {
  const { ok, output } = await runNode(['tools/build/build.js', ...args], {
    quiet: true,
    calm: true,
  });
  if (!ok) throw new Error(`${output}\nThe library did not build: see above.`);
}

/** The stories show the library as pages load it. They take their folder's place when they are whole. */
async function makeStories() {
  const { buildStories, STORIES } = await import('./stories.js');
  const next = `${STORIES}-next`;
  await build('--no-types');
  await buildStories(next, { calm: true });
  rmSync(STORIES, { recursive: true, force: true });
  renameSync(next, STORIES);
}

const LIBRARY = `${CACHE}/library`;

const makeLibrary = () =>
  keepCurrent(
    'library',
    () => existsSync(`${LIBRARY}/x3d-physics.js`),
    () => build('--quick', LIBRARY),
  );

/** What fails here leaves the documentation where it is. */
async function followWithStories(address) {
  const start = Date.now();
  console.log('The stories are built behind it, a minute or two, where anything has changed …');
  const { STORIES } = await import('./stories.js');
  await keepCurrent('stories', () => existsSync(`${STORIES}/index.html`), makeStories);
  console.log(`The stories are at ${address}stories/index.html, after ${seconds(start)}`);
}

async function main() {
  endWithStarters();
  await ensurePackages();
  await tell('Bundling the library', makeLibrary);
  const address = await serveSources(LIBRARY);
  console.log(`\nThe documentation is at ${address}   (Ctrl+C ends)\n`);
  await followWithStories(address).catch((error) => console.error(error.message));
}

main().catch((error) => {
  console.error(error.message);
  process.exit(1);
});
