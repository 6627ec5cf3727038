import { GeometryReader } from '../document/geometry-reader.js';
import { geometryOf, type Found } from '../matter/geometry-of.js';
import type { Binding } from '../nodes/binding.js';
import type { StandIn } from '../nodes/stand-in.js';
import type { Scope } from '../scopes/scope.js';
import { isPhysics, isShape, isTransform } from '../words/dom.js';
import type { SurfaceData } from './drawing/surface-data.js';
import { ownSheet, planeAt } from './sheets.js';
import { textureOf } from './texture.js';

export interface Surface extends Found<SurfaceData> {
  /** It says by itself what it is, which wins. */
  own: SurfaceData | undefined;
}

/** In itself, and then beside it, or in what it is for. */
export function surfaceOf(soft: Binding): Surface {
  const own = ownSheet(soft);
  const found = geometryOf(
    soft,
    (element, scope) => surfaceAt(soft, element, scope),
    (standIn) => isOfBody(soft, standIn),
  );
  return { ...found, own };
}

/** Shapes in a Transform that a body moves are that body's. */
const isOfBody = ({ scene }: Binding, { transform, shapes }: StandIn): boolean =>
  transform === shapes && scene!.drivers.of(transform) !== undefined;

/** Any geometry that could collide. */
function surfaceAt(soft: Binding, element: Element, scope: Scope): SurfaceData | undefined {
  if (isShape(element) || isTransform(element) || isPhysics(element)) return undefined;
  const plane = planeAt(soft, element, scope.units.length);
  if (plane) return plane;
  const geometry = new GeometryReader(soft).single([element], scope, () => true);
  return geometry && { geometry, texture: textureOf(soft, element, scope, geometry) };
}
