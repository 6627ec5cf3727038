// What x3dom knows: its own list, read in the page where it runs.
import type { ScenePage } from './frame.js';

interface X3dom {
  nodeTypes: Record<string, new () => { _vf: Record<string, unknown> }>;
  nodeTypesLC: Record<string, unknown>;
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
    const { _vf } = new (x3domOf(page).nodeTypes[name]!)();
    return new Map(Object.entries(_vf).map(([field, value]) => [field, String(value ?? '')]));
  } catch {
    return new Map();
  }
}
