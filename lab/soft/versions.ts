import { readFileSync } from 'node:fs';
import { others } from './engines.js';

/** Of the packages that are measured beside ours, as they are installed. */
export const versionsOf = (): Record<string, string> =>
  Object.fromEntries(
    others.map(({ id, package: name }) => {
      const text = readFileSync(
        new URL(`../../node_modules/${name}/package.json`, import.meta.url),
        'utf8',
      );
      return [id, (JSON.parse(text) as { version: string }).version];
    }),
  );
