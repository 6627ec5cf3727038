// What moves by itself while a page arrives, and what the page weighs: one or two of each kind, by phone and on a desk.
import type { Browser } from 'playwright';
import { arrivalOf, VISITORS } from '../../../tools/docs/arrival.js';
import { OWN_PAGES } from '../../../tools/docs/own-pages.js';
import { FOLDER } from '../../../tools/docs/site.js';

/** Of the shift that is called good, 0.1, a fifth: a frame is as high as its scene, to the height of a line below it. */
const SHIFT = 0.02;

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
          const { shift, moved, bytes } = await arrivalOf(browser, site, path, visitor, how);
          const who = `${path} by ${visitor.name}`;
          if (shift > SHIFT)
            faults.push(`${who} moves by ${shift.toFixed(3)}: ${moved.join('; ')}`);
          if (bytes > most * 1000) faults.push(`${who} weighs ${bytes} bytes, ${most} kB at most`);
        }
      }),
    );
  return faults;
}
