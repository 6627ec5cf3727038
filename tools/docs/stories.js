// The stories: built once for `npm start` and for their test.
import { BIN, runNode } from '../processes.js';

export const STORIES = 'storybook-static';

/** The pages of the lab's report, from its numbers. */
async function drawReport(options) {
  const report = await runNode(['--import', 'tsx', 'lab/run.ts', '--draw'], options);
  if (!report.ok) throw new Error(`${report.output}\nThe report could not be drawn: see above.`);
}

/** Builds the stories, which show the library as it lies in dist/, and the lab's report. */
export async function buildStories(folder = STORIES, { calm = false } = {}) {
  const options = { quiet: true, calm };
  await drawReport(options);
  const args = ['build', '--output-dir', folder, '--disable-telemetry', '--quiet'];
  const stories = await runNode([BIN.storybook, ...args], options);
  if (!stories.ok) throw new Error(`${stories.output}\nThe stories did not build: see above.`);
}
