// npm start: installs what is missing, builds the library, its documentation and its stories, serves them.
import { ensurePackages } from './install.js';
import { runNode } from './processes.js';

async function main() {
  await ensurePackages();
  console.log('Building the library …');
  if (!(await runNode(['tools/build.js'])).ok) throw new Error('The build failed: see above.');
  console.log('Building the documentation and the stories …');
  // Only now: it imports packages.
  const { buildDocs, serveDocs } = await import('./site.js');
  await buildDocs();
  const { port } = await serveDocs(6006);
  console.log(
    `\nThe documentation is at http://localhost:${port}/, the stories at …/stories/   (Ctrl+C ends)`,
  );
}

main().catch((error) => {
  console.error(error.message);
  process.exit(1);
});
