// The pages of the built site, as files.
import { readdirSync, readFileSync } from 'node:fs';
import { FOLDER } from '../../../tools/docs/site.js';

/** Of others, which have tests of their own. */
const ELSEWHERE = /^(stories|x3d-physics)\//;

export interface Page {
  /** Its address, from the site's root. */
  path: string;
  html: string;
}

export const pages = (): Page[] =>
  readdirSync(FOLDER, { recursive: true })
    .map((file) => String(file).replaceAll('\\', '/'))
    .filter((file) => file.endsWith('.html') && !ELSEWHERE.test(file))
    .sort()
    .map((file) => ({ path: `/${file}`, html: readFileSync(`${FOLDER}/${file}`, 'utf8') }));
