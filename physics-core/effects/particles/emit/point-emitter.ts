import type { Vec3 } from '../../../fields/types.js';
import { directionOf } from './directions.js';
import type { Emitter, Speeds } from './emitter.js';
import { areFinite, NOWHERE } from './finite.js';
import { emitterOf, placeAt } from './place.js';

export interface PointEmission extends Speeds {
  position: Vec3;
  /** Of any length; 0 0 0: another for each particle. */
  direction: Vec3;
}

/** From one point in one direction. */
export function pointEmitter({ position, direction, ...speeds }: PointEmission): Emitter {
  if (!areFinite([...position, ...direction])) return NOWHERE;
  return emitterOf(placeAt(position), directionOf(direction), speeds);
}
