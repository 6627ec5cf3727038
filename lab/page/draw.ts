import { readFileSync, writeFileSync } from 'node:fs';
import { between } from '../draw/between.js';
import { BROWSER_NAMES, pagesPicture } from '../draw/pages-chart.js';
import { markdownOf } from '../draw/table.js';
import { libraries } from './libraries/index.js';
import type { PageNumbers } from './numbers.js';
import { cellTable, ratioTable, startTable } from './tables.js';

const TEXT = new URL('../../docs/pages.md', import.meta.url);
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
export const withPages = (text: string, numbers: PageNumbers): string =>
  Object.entries({
    libraries: libraries.map(({ name, says }) => `- **${name}**: ${says}`).join('\n'),
    conditions: conditions(numbers),
    ratio: markdownOf(ratioTable(numbers)),
    start: markdownOf(startTable(numbers)),
    cells: allCells(numbers),
  }).reduce((now, [name, content]) => between(now, name, content), text);

/** The pictures and the page of the docs. */
export function drawPages(numbers: PageNumbers): void {
  for (const [scene, things] of Object.entries(THINGS))
    writeFileSync(picture(scene), pagesPicture(numbers, scene, things));
  writeFileSync(TEXT, withPages(readFileSync(TEXT, 'utf8'), numbers));
}
