import type { NodeData } from './fact.js';

export const isNode = (value: unknown): value is NodeData =>
  typeof value === 'object' && value !== null && ('type' in value || 'USE' in value);

/** The nodes in a field; undefined where it holds values. */
export function nodesIn(value: unknown): NodeData[] | undefined {
  if (isNode(value)) return [value];
  return Array.isArray(value) && value.length > 0 && value.every(isNode) ? value : undefined;
}

/** The node types of all DEFs in a scene. */
export function typesByName(scene: readonly NodeData[], into = new Map<string, string>()) {
  for (const node of scene) {
    if (node.DEF && node.type) into.set(node.DEF, node.type);
    for (const value of Object.values(node)) typesByName(nodesIn(value) ?? [], into);
  }
  return into;
}

/** The same nodes with other DEF names, so that scenes can stand side by side. */
export function renamed<T>(value: T, rename: (name: string) => string): T {
  if (Array.isArray(value)) return value.map((item: unknown) => renamed(item, rename)) as T;
  if (!isNode(value)) return value;
  const fields = Object.entries(value).map(([field, item]) => [
    field,
    (field === 'DEF' || field === 'USE') && item ? rename(item as string) : renamed(item, rename),
  ]);
  return Object.fromEntries(fields) as T;
}

const escaped = (text: string): string =>
  text.replace(/&/g, '&amp;').replace(/"/g, '&quot;').replace(/</g, '&lt;');

/** A value as X3D text. */
export function fieldText(value: unknown): string {
  if (!Array.isArray(value)) return String(value);
  const items = value.flat() as unknown[];
  return items.map((item) => (typeof item === 'string' ? `"${item}"` : String(item))).join(' ');
}

/** How a page spells things. */
export interface Spelling {
  types: Map<string, string>;
  tag: (type: string) => string;
}

/** A node as markup that both HTML and XML read; `containerField` where it stands in a field. */
export function markup(node: NodeData, spelling: Spelling, containerField?: string): string {
  const { type = spelling.types.get(node.USE!), ...rest } = node;
  if (!type) throw new Error(`the scene has no node ${node.USE}`);
  const tag = spelling.tag(type);
  let [attributes, children] = ['', ''];
  for (const [field, value] of Object.entries(rest)) {
    const nodes = nodesIn(value);
    if (nodes) children += nodes.map((each) => markup(each, spelling, field)).join('');
    else if (value !== undefined) attributes += ` ${field}="${escaped(fieldText(value))}"`;
  }
  if (containerField) attributes += ` containerField="${containerField}"`;
  return `<${tag}${attributes}>${children}</${tag}>`;
}

/**
 * The same scene with every node where it is first named, for readers that know no name before its DEF.
 */
export function definedFirst(scene: readonly NodeData[]): NodeData[] {
  const definitions = new Map<string, NodeData>();
  const collect = (node: NodeData): void => {
    if (node.DEF) definitions.set(node.DEF, node);
    for (const value of Object.values(node)) nodesIn(value)?.forEach(collect);
  };
  scene.forEach(collect);
  const written = new Set<string>();
  const place = (node: NodeData): NodeData => {
    const name = node.USE ?? node.DEF;
    if (name && written.has(name)) return { USE: name };
    if (name) written.add(name);
    const entries = Object.entries((name && definitions.get(name)) || node);
    return Object.fromEntries(
      entries.map(([field, value]) => {
        const nodes = nodesIn(value)?.map(place);
        return [field, nodes ? (Array.isArray(value) ? nodes : nodes[0]) : value];
      }),
    );
  };
  return scene.map(place);
}
