// What moves by itself while a page arrives, what the page weighs, and how much of that comes before its first word: one or two
// of each kind, by phone and on a desk.
import type { Browser } from 'playwright';
import { arrivalOf, VISITORS } from '../../../tools/docs/arrival.js';
import { OWN_PAGES } from '../../../tools/docs/own-pages.js';
import { FOLDER } from '../../../tools/docs/site.js';

/** Of the shift that is called good, 0.1, a fifth: a frame is as high as its scene, to the height of a line below it. */
const SHIFT = 0.02;

/** Bytes before the first word, a fifth more than those of the page that has most: a phone's slow line takes .3 s for them. */
const BEFORE = 62_000;

/** Milliseconds without anything that comes. */
const QUIET = 1500;

export const arrivals = OWN_PAGES.length * VISITORS.length;

export async function unsettled(browser: Browser, address: string): Promise<string[]> {
  const faults: string[] = [];
  for (const visitor of VISITORS)
    await Promise.all(
      [0, 1].map(async (half) => {
        for (const { path, most } of OWN_PAGES.filter((_, i) => i % 2 === half)) {
          const site = { address, folder: FOLDER };
          const how = { quiet: QUIET, slow: false };
          const { shift, moved, bytes, before } = await arrivalOf(
            browser,
            site,
            path,
            visitor,
            how,
          );
          const who = `${path} by ${visitor.name}`;
          if (shift > SHIFT)
            faults.push(`${who} moves by ${shift.toFixed(3)}: ${moved.join('; ')}`);
          if (bytes > most * 1000) faults.push(`${who} weighs ${bytes} bytes, ${most} kB at most`);
          if (before > BEFORE)
            faults.push(`${who} shows nothing before ${before} bytes, ${BEFORE} at most`);
        }
      }),
    );
  return faults;
}
