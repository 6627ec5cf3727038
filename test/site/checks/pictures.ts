// The menu of the playground shows each of its scenes.
import { existsSync, readFileSync } from 'node:fs';
import type { Example } from '../../../site/gather/examples.js';
import { MENU } from '../../../site/gather/thumbnails.js';
import { FOLDER } from '../../../tools/docs/site.js';

export const menu = (): Example[] =>
  JSON.parse(readFileSync(`${FOLDER}/${MENU}`, 'utf8')) as Example[];

export const unpictured = (examples: readonly Example[]): string[] =>
  examples
    .filter(({ picture }) => !existsSync(`${FOLDER}/${picture}`))
    .map(({ name, picture }) => `${name} has no picture ${picture}`);
