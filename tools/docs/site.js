// npm run docs: the documentation site, with the stories under /stories/, as one folder of files: site-static/.
//   --live      serves the site's sources and shows each edit at once, with the stories as they were built last
// dist/ must be built.
import { parseArgs } from 'node:util';
import { BIN, runNode } from '../processes.js';
import { serve } from './static-files.js';
import { buildStories } from './stories.js';

export const FOLDER = 'site-static';

async function must(what, args, options = { quiet: true }) {
  const { ok, output } = await runNode(args, options);
  if (!ok) throw new Error(`${output}\n${what} failed: see above.`);
}

/** What the site shows of the rest of the repository, and of a built library, put where its generator looks for it. */
export const gather = (library = 'dist') =>
  must('Gathering the pages', ['--import', 'tsx', 'site/gather/index.ts', library]);

/** The site by itself: what its test looks at. */
export async function buildSite() {
  await gather();
  await must('Pictures of the gallery', ['--import', 'tsx', 'site/gather/thumbnails.ts'], {});
  await must('The site', [BIN.vitepress, 'build', 'site']);
}

/** The stories come second: the site's generator empties its folder. */
export async function buildDocs() {
  await buildSite();
  await buildStories(`${FOLDER}/stories`);
}

/** `made`: pages beside those of the site. */
export const serveDocs = (port, made) => serve(FOLDER, port, made);

/** Serves the gathered pages from their sources on `port`, or on the next one that is free; answers the address. */
export async function serveLive(port) {
  const { createServer } = await import('vitepress');
  const server = await createServer('site', { port, host: true, cors: true });
  await server.listen();
  return server.resolvedUrls.local[0];
}

async function main() {
  const { values } = parseArgs({ options: { live: { type: 'boolean' } } });
  if (values.live) {
    await gather();
    console.log(`The site's sources are at ${await serveLive(6006)}   (Ctrl+C ends)`);
    return;
  }
  await buildDocs();
  console.log(`The site lies in ${FOLDER}/`);
}

if (process.argv[1]?.endsWith('site.js')) {
  main().catch((error) => {
    console.error(error.message);
    process.exitCode = 1;
  });
}
