import type { Mesh } from '../../../shapes/geometry.js';
import type { Direction } from './directions.js';
import type { Emitter, Speeds } from './emitter.js';
import { NOWHERE } from './finite.js';
import { emitterOf } from './place.js';
import { placeOn } from './surface-place.js';
import { trianglesOf } from './triangles.js';

export interface SurfaceEmission extends Speeds {
  mesh: Mesh;
}

/** The place brings its normal. */
const alongNormal: Direction = () => {};

/** From places on a surface, each area alike, along its normal. */
export function surfaceEmitter({ mesh, ...speeds }: SurfaceEmission): Emitter {
  const place = placeOn(trianglesOf(mesh));
  return place ? emitterOf(place, alongNormal, speeds) : NOWHERE;
}
