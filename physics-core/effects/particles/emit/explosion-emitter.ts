import type { Vec3 } from '../../../fields/types.js';
import { randomDirection } from './directions.js';
import type { Emitter, Speeds } from './emitter.js';
import { areFinite, NOWHERE } from './finite.js';
import { emitterOf, placeAt } from './place.js';

export interface ExplosionEmission extends Speeds {
  position: Vec3;
}

/** From one point in all directions. */
export function explosionEmitter({ position, ...speeds }: ExplosionEmission): Emitter {
  if (!areFinite(position)) return NOWHERE;
  return emitterOf(placeAt(position), randomDirection, speeds);
}
