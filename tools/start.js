// npm start: installs what is missing, builds the library and its stories, serves them.
import { ensurePackages } from './install.js';
import { runNode } from './processes.js';

async function main() {
  await ensurePackages();
  console.log('Building the library …');
  if (!(await runNode(['tools/build.js'])).ok) throw new Error('The build failed: see above.');
  console.log('Building the stories …');
  // Only now: it imports packages.
  const { buildStories, serveStories } = await import('./stories.js');
  await buildStories();
  const { port } = await serveStories(6006);
  console.log(`\nThe stories are at http://localhost:${port}/   (Ctrl+C ends)`);
}

main().catch((error) => {
  console.error(error.message);
  process.exit(1);
});
