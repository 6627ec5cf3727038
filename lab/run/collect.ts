import { setFlagsFromString } from 'node:v8';
import { runInNewContext } from 'node:vm';

setFlagsFromString('--expose-gc');

const gc = runInNewContext('gc') as (options?: { type: 'minor' }) => void;

/** Collects garbage now: what building a scene leaves is no cost of its steps. */
export const collect = (): void => gc();

/** Collects what was dropped lately, so that nobody's steps have to clear away what another left. */
export const collectYoung = (): void => gc({ type: 'minor' });
