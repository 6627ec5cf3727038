import type { Emitter, Speeds } from './emitter.js';

/** There is no place to be born. */
export const NOWHERE: Emitter = { emit: () => false };

export const areFinite = (values: ArrayLike<number>): boolean =>
  Array.prototype.every.call(values, Number.isFinite);

/** Whether no speed that may be drawn is beyond all numbers. */
export const areSpeeds = ({ speed, variation }: Speeds): boolean =>
  Number.isFinite(speed * (1 + Math.abs(variation)));
