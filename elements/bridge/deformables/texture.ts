import { codecs } from '../../../physics-core/inside.js';
import { meantBy } from '../document/geometry-reader.js';
import type { GeometryData } from '../geometry/geometry-fields.js';
import type { Binding } from '../nodes/binding.js';
import type { Scope } from '../scopes/scope.js';
import { attribute, lowerName } from '../words/dom.js';
import { nodeOf } from '../x3dom/x3dom.js';
import { spread, type Texture } from './drawing/surface-data.js';

/** What its author says of it, or what x3dom made of it where its points are those of x3dom. */
export function textureOf(
  user: Binding,
  element: Element,
  scope: Scope,
  data: GeometryData,
): Texture | undefined {
  const places = texCoord(user, [...element.children], scope);
  if (!places) return data.type === 'Mesh' ? ofMesh(element, data) : plainGrid(data);
  const text = attribute(element, 'texCoordIndex');
  const index = text === null ? undefined : (codecs.MFInt32.parse(text) as number[] | undefined);
  if (data.type !== 'IndexedFaceSet' || !index?.length) return { places };
  return { places, faces: { points: (data.coordIndex ?? []) as number[], places: index } };
}

function texCoord(user: Binding, elements: Element[], around: Scope): number[] | undefined {
  for (const child of elements) {
    const { element } = meantBy(user, child, around) ?? { element: child };
    if (lowerName(element) !== 'texturecoordinate') continue;
    user.scene!.readers.add(element, user);
    const text = attribute(element, 'point') ?? '';
    const places = codecs.MFFloat.parse(text) as number[] | undefined;
    if (!places) user.fault((faults) => faults.malformed(element, 'point', text));
    return places;
  }
  return undefined;
}

function ofMesh(element: Element, { points }: GeometryData): Texture | undefined {
  const lists = (nodeOf(element)?._mesh as { _texCoords?: ArrayLike<number>[] })?._texCoords ?? [];
  const places = lists.flatMap((list) => Array.from(list));
  return 3 * places.length === 2 * (points as number[]).length ? { places } : undefined;
}

/** An ElevationGrid has the whole of it. */
function plainGrid({ type, xDimension = 0, zDimension = 0 }: GeometryData): Texture | undefined {
  return type === 'ElevationGrid'
    ? { places: spread((xDimension as number) - 1, (zDimension as number) - 1) }
    : undefined;
}
