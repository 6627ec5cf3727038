import { codecs } from '../../../physics-core/inside.js';
import { GeometryReader } from '../document/geometry-reader.js';
import { geometryOf, type Found } from '../matter/geometry-of.js';
import type { Binding } from '../nodes/binding.js';
import type { Scope } from '../scopes/scope.js';
import { attribute, lowerName } from '../words/dom.js';

/** As the core takes it, metres. */
export interface LineData {
  type: string;
  coord: number[];
  [list: string]: unknown;
}

/** Lines of X3D, and which of their lists says what belongs together. */
const LINES: Record<string, [type: string, list: string]> = {
  lineset: ['LineSet', 'vertexCount'],
  indexedlineset: ['IndexedLineSet', 'coordIndex'],
};

/** In the rope itself, and then beside it, or in what it is for. */
export const lineOf = (rope: Binding): Found<LineData> =>
  geometryOf(rope, (element, scope) => lineAt(rope, element, scope));

function lineAt(rope: Binding, element: Element, scope: Scope): LineData | undefined {
  const [type, list] = LINES[lowerName(element)] ?? [];
  if (!type || !list) return undefined;
  rope.scene!.readers.add(element, rope);
  const coord = new GeometryReader(rope).coord([...element.children], scope);
  const text = attribute(element, list);
  const numbers = text === null ? undefined : codecs.MFInt32.parse(text);
  if (text !== null && !numbers) rope.fault((faults) => faults.malformed(element, list, text));
  return { type, coord, ...(numbers ? { [list]: numbers } : {}) };
}
