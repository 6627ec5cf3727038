import type { Vec3 } from '../../../fields/types.js';
import type { Mesh } from '../../../shapes/geometry.js';
import { closedOf } from './closed.js';
import { directionOf } from './directions.js';
import type { Emitter, Speeds } from './emitter.js';
import { areFinite, NOWHERE } from './finite.js';
import { emitterOf } from './place.js';
import { placeOn } from './surface-place.js';
import { trianglesOf } from './triangles.js';
import { placeWithin } from './volume-place.js';

export interface VolumeEmission extends Speeds {
  /** Closed. */
  mesh: Mesh;
  /** FALSE: on its surface. */
  internal: boolean;
  /** Of any length; 0 0 0: another for each particle. */
  direction: Vec3;
}

/** From places in a volume, each volume alike, or on its surface, each area alike, in one direction. */
export function volumeEmitter({ mesh, internal, direction, ...speeds }: VolumeEmission): Emitter {
  const triangles = trianglesOf(mesh);
  const { closed, oriented } = closedOf(triangles);
  if (!closed || !areFinite(direction)) return NOWHERE;
  const place = internal ? placeWithin(triangles, oriented) : placeOn(triangles);
  return place ? emitterOf(place, directionOf(direction), speeds) : NOWHERE;
}
