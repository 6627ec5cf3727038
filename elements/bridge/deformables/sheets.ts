import { sheet } from '../../../physics-core/deformables.js';
import { codecs } from '../../../physics-core/inside.js';
import type { Binding } from '../nodes/binding.js';
import { attribute, lowerName } from '../words/dom.js';
import { spread, type SurfaceData } from './drawing/surface-data.js';

type Pair = [number, number];

/** X3DOM's default, metres. */
const PLANE: Pair = [2, 2];

/** What a Cloth says of itself: with a `size`, it is a sheet. */
export function ownSheet(soft: Binding): SurfaceData | undefined {
  const [width, height] = asked(soft, 'size') ?? [0, 0];
  return width > 0 && height > 0 ? sheetOf([width, height], cellsOf(soft)) : undefined;
}

/** An X3DOM Plane lies as such a sheet does; where it says no cells but its default, one, with those of the Cloth. */
export function planeAt(soft: Binding, element: Element, length: number): SurfaceData | undefined {
  if (lowerName(element) !== 'plane') return undefined;
  soft.scene!.readers.add(element, soft);
  const said = (name: string): Pair | undefined => {
    const text = attribute(element, name);
    const value = text === null ? undefined : (codecs.SFVec2f.parse(text) as Pair | undefined);
    if (text !== null && !value) soft.fault((faults) => faults.malformed(element, name, text));
    return value;
  };
  const size = (said('size') ?? PLANE).map((each) => each * length) as Pair;
  // X3DOM writes its defaults into the document.
  const cells = said('subdivision') ?? [1, 1];
  const isDivided = cells.some((n) => n > 1);
  const { geometry, texture } = sheetOf(size, isDivided ? cells : cellsOf(soft));
  const centre = codecs.SFVec3f.parse(attribute(element, 'center') ?? '') as number[] | undefined;
  if (centre) {
    const points = geometry.points as number[];
    points.forEach((each, i) => (points[i] = each + centre[i % 3]! * length));
  }
  return { geometry, texture, cells: !isDivided && soft.type.fields.subdivision !== undefined };
}

const asked = (soft: Binding, name: string): Pair | undefined =>
  soft.type.fields[name] &&
  (codecs.SFVec2f.accept(soft.authoredFields()[name] ?? soft.type.fields[name].default) as
    Pair | undefined);

const cellsOf = (soft: Binding): Pair => asked(soft, 'subdivision') ?? [1, 1];

function sheetOf([width, height]: Pair, asked: Pair): SurfaceData {
  const cells = asked.map((n) => Math.min(200, Math.max(1, Math.round(n)))) as Pair;
  return {
    geometry: { type: 'Mesh', ...sheet(width, height, cells) },
    texture: { places: spread(...cells) },
  };
}
