import { readFileSync, writeFileSync } from 'node:fs';
import { between } from '../draw/between.js';
import { BROWSER_NAMES, pagesPicture } from '../draw/pages-chart.js';
import { markdownOf } from '../draw/table.js';
import { threadsPicture } from '../draw/threads-chart.js';
import { libraries } from './libraries/index.js';
import type { PageNumbers } from './numbers.js';
import { cellTable, ratioTable, startTable } from './tables.js';
import type { ThreadNumbers } from './threads/numbers.js';
import { guideTable, threadConditions, threadTable } from './threads/tables.js';

const TEXT = new URL('../../docs/pages.md', import.meta.url);
const GUIDE = new URL('../../site/guide/thread.md', import.meta.url);
const picture = (scene: string): URL =>
  new URL(`../../docs/pictures/pages-${scene}.svg`, import.meta.url);

/** What stands at the bottom of each picture. */
export const THINGS: Record<string, string> = { boxes: 'boxes', links: 'joints' };

function conditions({ warmUp, turns, frames, browsers }: PageNumbers): string {
  const where = Object.entries(browsers).map(
    ([name, { version, date, machine }]) =>
      `- ${BROWSER_NAMES[name]} ${version}, ${date}: ${machine}`,
  );
  return `${turns} turns of ${frames} frames each, after ${warmUp}:\n\n${where.join('\n')}`;
}

const allCells = (numbers: PageNumbers): string =>
  Object.entries(THINGS)
    .flatMap(([scene, things]) =>
      Object.keys(numbers.browsers).flatMap((name) => {
        const table = cellTable(numbers, name, scene);
        if (table.rows.length === 0) return [];
        return `### ${things} in ${BROWSER_NAMES[name]}\n\n${markdownOf(table)}`;
      }),
    )
    .join('\n\n');

/** docs/pages.md with what these numbers say. */
export const withPages = (text: string, numbers: PageNumbers, threads: ThreadNumbers): string =>
  Object.entries({
    libraries: libraries.map(({ name, says }) => `- **${name}**: ${says}`).join('\n'),
    conditions: conditions(numbers),
    ratio: markdownOf(ratioTable(numbers)),
    threads: `${threadConditions(threads)}\n\n${markdownOf(threadTable(threads))}`,
    start: markdownOf(startTable(numbers)),
    cells: allCells(numbers),
  }).reduce((now, [name, content]) => between(now, name, content), text);

/** The guide's page on threads with what these numbers say. */
export const withThreads = (text: string, threads: ThreadNumbers): string =>
  between(text, 'threads', markdownOf(guideTable(threads)));

/** The pictures and the page of the docs, and what the guide has of them. */
export function drawPages(numbers: PageNumbers, threads: ThreadNumbers): void {
  for (const [scene, things] of Object.entries(THINGS))
    writeFileSync(picture(scene), pagesPicture(numbers, scene, things));
  writeFileSync(picture('threads'), threadsPicture(threads));
  writeFileSync(GUIDE, withThreads(readFileSync(GUIDE, 'utf8'), threads));
  writeFileSync(TEXT, withPages(readFileSync(TEXT, 'utf8'), numbers, threads));
}
