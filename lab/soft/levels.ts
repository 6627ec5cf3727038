import { levels } from '../../physics-core/inside.js';
import { stepOf } from '../draw/numbers.js';
import type { SoftSetting } from './engine.js';

export const levelNames: readonly string[] = levels.map(({ name }) => name);

/** The level that others are compared with. */
export const COMPARED = 'standard';

/** In words: a level, or step and rounds. */
export function nameOf({ level, step, iterations, reaches }: SoftSetting): string {
  if (level) return level;
  return `${stepOf(step)} × ${iterations}${reaches ? ', LRA' : ''}`;
}
