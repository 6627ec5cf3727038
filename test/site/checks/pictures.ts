// The menu of the playground shows each of its scenes, and of each something.
import { existsSync, readFileSync } from 'node:fs';
import type { Browser } from 'playwright';
import type { Example } from '../../../site/gather/examples.js';
import { MENU } from '../../../site/gather/thumbnails.js';
import { FOLDER } from '../../../tools/docs/site.js';
import { decoder, shareColored } from './picture.js';

export const menu = (): Example[] =>
  JSON.parse(readFileSync(`${FOLDER}/${MENU}`, 'utf8')) as Example[];

/** Of 255: sky and floor have less between their brightest and their darkest channel, what the kit colours more. */
const COLORED = 60;
/** Share of a picture: a few pixels of the smallest. */
const LEAST = 0.0001;

export async function unpictured(
  browser: Browser,
  examples: readonly Example[],
): Promise<string[]> {
  const context = await browser.newContext();
  const read = await decoder(context);
  const faults: string[] = [];
  for (const { name, picture } of examples) {
    const file = `${FOLDER}/${picture}`;
    if (!existsSync(file)) faults.push(`${name} has no picture ${picture}`);
    else if (shareColored(await read(readFileSync(file)), COLORED) < LEAST)
      faults.push(`${picture} shows sky and floor alone`);
  }
  await context.close();
  return faults;
}
