// The chunk `snapshots`.
import type { DenseCode } from '../dense.js';
import { kindsOf, statesIn } from './kinds.js';
import { packMoment, unpackMoment } from './moment.js';

export const provide = (): DenseCode => ({
  kindsOf,
  statesIn,
  pack: packMoment,
  unpack: unpackMoment,
});
