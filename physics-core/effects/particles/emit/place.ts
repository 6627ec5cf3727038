import type { Vec3 } from '../../../fields/types.js';
import type { Draws } from './draws.js';
import { giveSpeed, type Direction } from './directions.js';
import type { Emitter, Speeds } from './emitter.js';
import { areSpeeds, NOWHERE } from './finite.js';

/** Writes the place of a birth. FALSE: it found none. */
export type Place = (draws: Draws, birth: Float64Array) => boolean;

/** Always the same one. */
export const placeAt =
  (position: Vec3): Place =>
  (_, birth) => {
    for (let k = 0; k < 3; k++) birth[k] = position[k]!;
    return true;
  };

/** Draws a place, then a direction, then a speed. */
export function emitterOf(place: Place, direction: Direction, speeds: Speeds): Emitter {
  if (!areSpeeds(speeds)) return NOWHERE;
  return {
    emit(draws, birth) {
      if (!place(draws, birth)) return false;
      direction(draws, birth);
      giveSpeed(draws, speeds, birth);
      return true;
    },
  };
}
