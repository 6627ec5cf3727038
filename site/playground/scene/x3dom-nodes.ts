// What x3dom knows: its own list, read in the page where it runs.
import type { ScenePage } from './frame.js';

interface X3dom {
  nodeTypes: Record<string, unknown>;
  nodeTypesLC: Record<string, new () => { _vf: Record<string, unknown> }>;
}

const x3domOf = (page: ScenePage): X3dom => (page as unknown as { x3dom: X3dom }).x3dom;

/** Tags in lower case. */
export const x3domTags = (page: ScenePage): string[] => Object.keys(x3domOf(page).nodeTypesLC);

/** Names of nodes in X3D's case, without those that no markup has. */
export const x3domNodes = (page: ScenePage): string[] =>
  Object.keys(x3domOf(page).nodeTypes).filter((name) => !/^X3D|^[a-z_]/.test(name));

/** A node's fields and their defaults, as text; none where x3dom makes no node without an element. */
export function x3domFields(page: ScenePage, name: string): Map<string, string> {
  try {
    const { _vf } = new (x3domOf(page).nodeTypesLC[name.toLowerCase()]!)();
    return new Map(Object.entries(_vf).map(([field, value]) => [field, String(value ?? '')]));
  } catch {
    return new Map();
  }
}

/** What x3dom takes where an element of its own has no such attribute; undefined where that is no field of it. */
export function x3domDefault(
  page: ScenePage,
  { localName }: Element,
  attribute: string,
): string | undefined {
  const key = attribute.toLowerCase();
  for (const [field, value] of x3domFields(page, localName)) {
    if (field.toLowerCase() === key) return value;
  }
  return undefined;
}
