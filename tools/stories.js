// The stories: built once for `npm start` and for their test.
import { BIN, runNode } from './processes.js';
import { serve } from './static-files.js';

const FOLDER = 'storybook-static';

/** Builds the stories, which show the library as it lies in dist/. */
export async function buildStories() {
  const args = ['build', '--output-dir', FOLDER, '--disable-telemetry', '--quiet'];
  const stories = await runNode([BIN.storybook, ...args], { quiet: true });
  if (!stories.ok) throw new Error(`${stories.output}\nThe stories did not build: see above.`);
}

export const serveStories = (port) => serve(FOLDER, port);
