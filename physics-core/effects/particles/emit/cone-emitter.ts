import { capDirection } from './directions.js';
import type { Emitter } from './emitter.js';
import { areFinite, NOWHERE } from './finite.js';
import { emitterOf, placeAt } from './place.js';
import type { PointEmission } from './point-emitter.js';

export interface ConeEmission extends PointEmission {
  /** Between the direction and the cone's side, radians: π is all around. */
  angle: number;
}

/** From one point, evenly into all of a cone's solid angle. */
export function coneEmitter({ position, direction, angle, ...speeds }: ConeEmission): Emitter {
  if (!areFinite([...position, ...direction, angle])) return NOWHERE;
  return emitterOf(placeAt(position), capDirection(direction, angle), speeds);
}
