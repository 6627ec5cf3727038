import { codecs } from '../../../physics-core/inside.js';
import { GeometryReader, meantBy } from '../document/geometry-reader.js';
import { standInOf } from '../document/shortcuts.js';
import type { Binding } from '../nodes/binding.js';
import type { Scope } from '../scopes/scope.js';
import { attribute, isShape, lowerName } from '../words/dom.js';

/** As the core takes it, metres. */
export interface LineData {
  type: string;
  coord: number[];
  [list: string]: unknown;
}

/** What a rope is laid along, and the Shape that is seen of it. */
export interface Found {
  line?: LineData | undefined;
  shape?: Element | undefined;
}

/** Lines of X3D, and which of their lists says what belongs together. */
const LINES: Record<string, [type: string, list: string]> = {
  lineset: ['LineSet', 'vertexCount'],
  indexedlineset: ['IndexedLineSet', 'coordIndex'],
};

const NO_GEOMETRY = /^(appearance|metadata.*)$/;

/** In the rope itself, and then beside it, or in what it is for. */
export function lineOf(rope: Binding): Found {
  const own = rope.named('geometry') ?? [...rope.element.children];
  const within = pick(rope, own, rope.scope!);
  const standIn = standInOf(rope);
  if (!standIn || (within.line && within.shape)) return within;
  const { shapes, scope } = standIn;
  rope.scene!.readers.add(shapes, rope);
  const around = pick(rope, isShape(shapes) ? [shapes] : [...shapes.children], scope);
  return { line: within.line ?? around.line, shape: within.shape ?? around.shape };
}

/** The first line; of Shapes the first that has one, else the first that has no geometry at all: that is for the rope. */
function pick(rope: Binding, elements: Element[], around: Scope): Found {
  let empty: Element | undefined;
  for (const each of elements) {
    const { element, scope } = meantBy(rope, each, around) ?? { element: each, scope: around };
    const line = lineAt(rope, element, scope);
    if (line) return { line };
    if (!isShape(element)) continue;
    rope.scene!.readers.add(element, rope);
    const parts = [...element.children].map(
      (part) => meantBy(rope, part, scope) ?? { element: part, scope },
    );
    for (const part of parts) {
      const inside = lineAt(rope, part.element, part.scope);
      if (inside) return { line: inside, shape: element };
    }
    if (parts.every((part) => NO_GEOMETRY.test(lowerName(part.element)))) empty ??= element;
  }
  return { shape: empty };
}

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
