import { levels, type LevelName } from '../../physics-core/inside.js';
import type { StabilityCase } from './case.js';

const names = levels.map(({ name }) => name);

/** The levels that a case is looked at, coarse to fine. */
export const levelsOf = ({ finest }: StabilityCase): LevelName[] =>
  finest ? names.slice(0, names.indexOf(finest) + 1) : names;

/** Whether it is promised there. */
export const promises = (
  { promisedFrom, refutedAt = [] }: StabilityCase,
  level: LevelName,
): boolean =>
  promisedFrom !== null &&
  names.indexOf(level) >= names.indexOf(promisedFrom) &&
  !refutedAt.includes(level);
