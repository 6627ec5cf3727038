import { nodeTypes } from '../../../physics-core/inside.js';

/** What one row of tables looks like from here. */
export type NodeType = (typeof nodeTypes)[string];
export type Field = NodeType['fields'][string];

// Node, where servers render pages, has no Element.
const getAttribute = globalThis.Element?.prototype.getAttribute;

/**
 * An attribute as the author wrote it. x3dom replaces `getAttribute` on its elements by one that answers defaults.
 * HTML lowercases names, XML keeps them; both are accepted.
 */
export function attribute(element: Element, name: string): string | null {
  return getAttribute.call(element, name) ?? getAttribute.call(element, name.toLowerCase());
}

/** What it is called by: its DEF, else its id. */
export const nameOf = (element: Element): string | undefined =>
  attribute(element, 'DEF') ?? attribute(element, 'id') ?? undefined;

/** Its tag and its name, as `querySelector` takes them. */
export function selectorOf(element: Element): string {
  const named = ['id', 'DEF', 'def'].find((name) => getAttribute.call(element, name) !== null);
  if (!named) return element.localName;
  const name = getAttribute.call(element, named)!.replace(/["\\]/g, '\\$&');
  return `${element.localName}[${named}="${name}"]`;
}

export const lowerName = (element: Element): string => element.localName.toLowerCase();

export const isX3D = (element: Element): boolean => lowerName(element) === 'x3d';
export const isScene = (element: Element): boolean => lowerName(element) === 'scene';
export const isInline = (element: Element): boolean => lowerName(element) === 'inline';
export const isShape = (element: Element): boolean => lowerName(element) === 'shape';

const TRANSFORMS = new Set(['transform', 'matrixtransform']);
export const isTransform = (element: Element): boolean => TRANSFORMS.has(lowerName(element));

/** Templates: what stands in them is no node yet. */
const TEMPLATES = new Set(['protodeclare', 'externprotodeclare', 'template']);
export const isTemplate = (element: Element): boolean => TEMPLATES.has(lowerName(element));

export const kebab = (name: string): string =>
  name.replace(/[A-Z]/g, (letter, at) => (at ? '-' : '') + letter.toLowerCase());

export const camel = (name: string): string =>
  name.replace(/-[a-z]/g, (letter) => letter[1].toUpperCase());

export const tagOf = (type: NodeType): string => `x3d-${kebab(type.name)}`;

const typesByName = new Map<string, NodeType>();
/** Tags mean nodes of these types, too. */
export function addTypes(types: Readonly<Record<string, NodeType>>): void {
  for (const type of Object.values(types)) {
    typesByName.set(type.name.toLowerCase(), type);
    typesByName.set(tagOf(type), type);
  }
}

addTypes(nodeTypes);

/** All that tags may mean so far. */
export const knownTypes = (): Set<NodeType> => new Set(typesByName.values());

/** The physics node that an element of either spelling stands for. */
export const typeOf = (element: Element): NodeType | undefined =>
  typesByName.get(lowerName(element)) ?? typeOfClass(element);

/** Our classes may be defined under other tags. */
function typeOfClass(element: Element): NodeType | undefined {
  if (!element.localName.includes('-')) return undefined;
  const { type } = element.constructor as { type?: NodeType };
  return type && typesByName.get(tagOf(type)) === type ? type : undefined;
}

/** The types a physics child may be, given by its name: used where roles are told apart. */
export const isType = (element: Element, ...names: string[]): boolean => {
  const type = typeOf(element);
  return type !== undefined && names.includes(type.name);
};

export const containerField = (element: Element): string | null =>
  attribute(element, 'containerField');

export const isPhysics = (element: Element): boolean => typeOf(element) !== undefined;

export const isCustom = (element: Element): boolean =>
  element.localName.startsWith('x3d-') && element.namespaceURI === 'http://www.w3.org/1999/xhtml';

/**
 * The outermost of what an element stands in: the document of a page or an XML file. What x3dom makes of a JSON file has
 * the page's `ownerDocument` and stands in no document at all: there it is the X3D element.
 */
export const fileOf = (element: Element): Document | Element =>
  element.getRootNode() as Document | Element;

/** The elements under (and with) a root, in document order, leaving templates out. */
export function* subtree(root: Element): Generator<Element> {
  if (isTemplate(root)) return;
  yield root;
  for (const child of root.children) yield* subtree(child);
}

/** Order of two elements of one tree. */
export const precedes = (a: Node, b: Node): number =>
  a === b ? 0 : a.compareDocumentPosition(b) & Node.DOCUMENT_POSITION_FOLLOWING ? -1 : 1;
