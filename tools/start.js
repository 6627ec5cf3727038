// npm start: installs what is missing, builds the library and its stories, serves them.
import { ensurePackages } from './install.js';
import { BIN, runNode } from './processes.js';
import { serve } from './static-files.js';

async function main() {
  await ensurePackages();
  console.log('Building the library …');
  if (!(await runNode(['tools/build.js'])).ok) throw new Error('The build failed: see above.');
  console.log('Building the stories …');
  const args = ['build', '--output-dir', 'storybook-static', '--disable-telemetry', '--quiet'];
  const stories = await runNode([BIN.storybook, ...args], { quiet: true });
  if (!stories.ok) throw new Error(`${stories.output}\nThe stories did not build: see above.`);
  const { port } = await serve('storybook-static', 6006);
  console.log(`\nThe stories are at http://localhost:${port}/   (Ctrl+C ends)`);
}

main().catch((error) => {
  console.error(error.message);
  process.exit(1);
});
