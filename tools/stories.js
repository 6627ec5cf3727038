// The stories: built once for `npm start` and for their test.
import { BIN, runNode } from './processes.js';
import { serve } from './static-files.js';

const FOLDER = 'storybook-static';

/** The pages of the lab's report, from its numbers. */
async function drawReport() {
  const report = await runNode(['--import', 'tsx', 'lab/run.ts', '--draw'], { quiet: true });
  if (!report.ok) throw new Error(`${report.output}\nThe report could not be drawn: see above.`);
}

/** Builds the stories, which show the library as it lies in dist/, and the lab's report. */
export async function buildStories(folder = FOLDER) {
  await drawReport();
  const args = ['build', '--output-dir', folder, '--disable-telemetry', '--quiet'];
  const stories = await runNode([BIN.storybook, ...args], { quiet: true });
  if (!stories.ok) throw new Error(`${stories.output}\nThe stories did not build: see above.`);
}

export const serveStories = (port) => serve(FOLDER, port);
