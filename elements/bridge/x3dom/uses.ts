import { attribute, isPhysics, isTemplate, isTransform, isType } from '../words/dom.js';
import { nodeOf, type NameSpace, type X3DNode, type X3DOM } from './x3dom.js';

// x3dom drops a USE that it meets before its DEF, and breaks off where a geometry lacks its Coordinate for that; it does
// not look into what it does not know, a Script's fields; and what stands in itself by USE it follows until its stack is
// full. So what is USEd is set up as soon as it is asked for, and never in itself.

/** Whom that is told. */
export interface UseListener {
  /** A USE of something that it stands in itself. */
  circleRefused(use: Element): void;
}

/** What is set up before x3dom comes to it: it is there already then. */
const early = new WeakSet<Element>();
/** What was inserted, while x3dom reads it: what else is new comes later, and what it names with it. */
let added: Element | undefined;
/** What is being set up now: each stands in the one before. */
const open = new Set<Element>();

/** USEs of what they stand in. */
const refused = new WeakSet<Element>();

/** Whether x3dom is to have nothing for it. */
export const isRefused = (use: Element): boolean => refused.has(use);

export function watchUses(x: X3DOM, listener: UseListener): void {
  const { prototype } = x.NodeNameSpace;
  const { setupTree } = prototype;

  prototype.setupTree = function (node, parent): X3DNode | null {
    if (!isElement(node)) return setupTree.call(this, node, parent);
    if (early.delete(node)) return nodeOf(node) ?? null;
    const name = attribute(node, 'USE');
    if (name === null) return setUp(this, node, parent);
    if (!this.defMap[name]) setUpEarly(this, node, name);
    const meant = this.defMap[name];
    if (!meant || !isCircle(meant, node)) return setupTree.call(this, node, parent);
    if (!refused.has(node)) listener.circleRefused(node);
    refused.add(node);
    return null;
  };

  const { prototype: documents } = x.X3DDocument;
  const { onNodeAdded } = documents;

  documents.onNodeAdded = function (element, parent): void {
    const before = added;
    added = element;
    try {
      onNodeAdded.call(this, element, parent);
    } finally {
      added = before;
    }
  };

  function setUp(space: NameSpace, element: Element, parent: X3DNode | null): X3DNode | null {
    open.add(element);
    try {
      return setupTree.call(space, element, parent);
    } catch (error) {
      if (!waits(element)) throw error;
      return nodeOf(element) ?? null;
    } finally {
      open.delete(element);
    }
  }

  function setUpEarly(space: NameSpace, use: Element, name: string): void {
    const element = bearerNear(use, name);
    if (!element || open.has(element) || nodeOf(element)) return;
    if (added && !added.contains(element)) return;
    if (!x.nodeTypesLC[element.localName.toLowerCase()]) return;
    if (setUp(space, element, null)) early.add(element);
  }
}

const isElement = (node: Node): node is Element => node.nodeType === Node.ELEMENT_NODE;

/** A geometry whose Coordinate comes with a file: x3dom breaks off, and is shown it when it is there. */
const waits = ({ children }: Element): boolean =>
  [...children].some((child) => attribute(child, 'USE') !== null && !nodeOf(child));

function isCircle(meant: X3DNode, use: Element): boolean {
  const parent = use.parentElement;
  if (!parent || !draws(parent, use)) return false;
  if (meant._xmlNode && open.has(meant._xmlNode)) return true;
  const node = nodeOf(parent);
  return node !== undefined && standsIn(node, meant);
}

/** Of our own nodes only collidables draw what is in them, but for the Transform that they name. */
const draws = (parent: Element, child: Element): boolean =>
  !isPhysics(parent) ||
  (isType(parent, 'CollidableShape', 'CollidableOffset') && !isTransform(child));

/** Whether `node` is `outer` or in it. */
function standsIn(node: X3DNode, outer: X3DNode, asked = new Set<X3DNode>()): boolean {
  if (node === outer) return true;
  if (asked.has(node)) return false;
  asked.add(node);
  return node._parentNodes.some((parent) => standsIn(parent, outer, asked));
}

/** DEFs of a tree, for as long as it is read. */
const known = new Map<Node, Map<string, Element>>();

/** The last element of that DEF in the tree of a USE. */
function bearerNear(use: Element, name: string): Element | undefined {
  let root: Element = use;
  while (root.parentElement && root.localName.toLowerCase() !== 'scene') root = root.parentElement;
  if (known.size === 0) queueMicrotask(() => known.clear());
  const defs = known.get(root) ?? defsIn(root);
  known.set(root, defs);
  return defs.get(name);
}

function defsIn(root: Element, defs = new Map<string, Element>()): Map<string, Element> {
  if (isTemplate(root)) return defs;
  const name = attribute(root, 'DEF');
  if (name !== null) defs.set(name, root);
  for (const child of root.children) defsIn(child, defs);
  return defs;
}
