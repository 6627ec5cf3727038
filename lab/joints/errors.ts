import { casesNamed } from '../cases/index.js';
import { iterated } from '../engines/ours.js';
import { measureCases, THOROUGH } from '../run/measure.js';
import { progress } from '../run/progress.js';
import type { Row } from '../run/row.js';

/** Cases of the report that are chains. */
export const chains = casesNamed('chain');

/** The chains by Bullet's iterations alone. */
export async function chainsIterated(): Promise<Row[]> {
  const entries = iterated.settings.map((setting) => ({ engine: iterated, setting }));
  const { rows } = await measureCases(chains, entries, { pains: THOROUGH, fresh: true, progress });
  return rows;
}
