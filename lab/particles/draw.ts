import { readFileSync, writeFileSync } from 'node:fs';
import { between } from '../draw/between.js';
import { threeDigits } from '../draw/numbers.js';
import { particlesPicture } from '../draw/particles-chart.js';
import { markdownOf } from '../draw/table.js';
import { libraries, type Library } from './libraries.js';
import type { Conditions, ParticleNumbers } from './numbers.js';
import { nodeTable, pageTable, summaryOf } from './tables.js';

const TEXT = new URL('../../docs/particles-price.md', import.meta.url);
const GUIDE = new URL('../../docs/particles.md', import.meta.url);
const PICTURE = new URL('../../docs/pictures/particles.svg', import.meta.url);

/** More than this on each core, and others were at work. */
const BUSY = 1;

function conditionsOf({ machine, date, load }: Conditions): string {
  const busy =
    load > BUSY
      ? ' **The machine had other work beside**: ratios bear that, milliseconds less so.'
      : '';
  return `${date}, ${machine}, a load of ${threeDigits(load)} on each core.${busy}`;
}

const lineOf = ({ id, name, package: by, says }: Library, { versions }: ParticleNumbers): string =>
  `- **${name}**, ${by} ${versions[id]}: ${says}`;

/** docs/particles-price.md with what these numbers say. */
export const withParticles = (text: string, numbers: ParticleNumbers): string =>
  Object.entries({
    libraries: libraries.map((library) => lineOf(library, numbers)).join('\n'),
    node: `${markdownOf(nodeTable(numbers))}\n\n${conditionsOf(numbers.node)}`,
    page: `${markdownOf(pageTable(numbers))}\n\nChromium ${numbers.chromium.version}, ${conditionsOf(numbers.chromium)}`,
    pains: `${numbers.count} particles of each system; ${numbers.turns} turns of each side, of ${numbers.each} steps or frames.`,
  }).reduce((now, [name, content]) => between(now, name, content), text);

/** docs/particles.md with the least that one wants to know of them. */
export const withCost = (text: string, numbers: ParticleNumbers): string =>
  between(text, 'cost', summaryOf(numbers));

export function drawParticles(numbers: ParticleNumbers): void {
  writeFileSync(PICTURE, particlesPicture(numbers));
  writeFileSync(GUIDE, withCost(readFileSync(GUIDE, 'utf8'), numbers));
  writeFileSync(TEXT, withParticles(readFileSync(TEXT, 'utf8'), numbers));
}
