import { ownBinding, type Binding } from '../nodes/binding.js';
import { addTypes, isTransform, knownTypes, tagOf, type NodeType } from '../words/dom.js';
import { holdsNodes } from '../words/fields.js';
import { placeAsWritten } from '../drawing/place.js';
import { cureListeners } from '../x3dom/late.js';
import { surviveLostContext } from '../x3dom/lost-context.js';
import { watchRoutes } from './route-ends.js';
import { watchTransforms, type TransformListener } from '../x3dom/transform-edits.js';
import { watchUses, type UseListener } from '../x3dom/uses.js';
import { fromX3DOM, toX3DOM } from '../x3dom/values.js';
import {
  nodeOf,
  type NodeContext,
  type X3DNode,
  type PhysicsX3DNode,
  type X3DNodeClass,
  type X3DOM,
} from '../x3dom/x3dom.js';

/** `_vf` of a node whose values are live: reading asks the simulation, writing leaves a value for fieldChanged. */
function liveFields(
  node: X3DNode & { readonly binding: Binding },
  type: NodeType,
  x: X3DOM,
  written: Map<string, unknown>,
): void {
  for (const [name, field] of Object.entries(type.fields)) {
    Object.defineProperty(node._vf, name, {
      enumerable: true,
      configurable: true,
      get: () => toX3DOM(field, node.binding.get(name), x),
      set: (value: unknown) => written.set(name, value),
    });
  }
}

/** By `_routes`, whose keys are from&field&to&field: the watchers count incoming ROUTEs too. */
function fieldsOfRoutes(routes: Record<string, unknown>, type: NodeType): string[] {
  const fields = Object.keys(routes).map((key) => key.split('&')[1]);
  return [...new Set(fields)].filter((field) => field in type.fields);
}

/** What the simulation changes. */
const outputsOf = (type: NodeType): string[] =>
  Object.entries(type.fields)
    .filter(([, { access, read }]) => access === 'outputOnly' || (read && access === 'inputOutput'))
    .map(([name]) => name);

/** For the page's own listeners x3dom has one event, sent from the node that changed. */
const OUTPUT_EVENT = 'outputchange';

function isListenedTo({ _listeners, element }: PhysicsX3DNode): boolean {
  return (
    (_listeners[OUTPUT_EVENT]?.length ?? 0) > 0 ||
    element?.hasAttribute(`on${OUTPUT_EVENT}`) === true
  );
}

/** Whom our node types and hooks tell. */
export interface Listener extends TransformListener, UseListener {
  nodeMade(element: Element): void;
  routed(node: PhysicsX3DNode): void;
  inlineSettled(inline: Element, loaded: boolean): void;
}

/** A node type of x3dom that hands its fields to our node. */
function makeType(base: X3DNodeClass, type: NodeType, x: X3DOM, listener: Listener): X3DNodeClass {
  return class extends base implements PhysicsX3DNode {
    readonly element: Element | null;
    readonly #written = new Map<string, unknown>();
    #busy = false;
    #emitting = false;
    #routed: string[] | undefined;

    constructor(context: NodeContext) {
      // Without an element x3dom neither reads attributes nor writes its defaults and accessors to it.
      super({ ...context, xmlNode: null });
      this.element = context.xmlNode;
      liveFields(this, type, x, this.#written);
      for (const [name, field] of Object.entries(type.fields))
        if (holdsNodes(field)) this._cfFieldTypes[name] = field.type;
      if (this.element) {
        placeAsWritten(this.binding, this);
        cureListeners(this.element);
        listener.nodeMade(this.element);
      }
    }

    get binding(): Binding {
      return ownBinding(this.element!)!;
    }

    /** Attributes come to us from our own observer. */
    override updateField(): void {}

    override fieldChanged(name: string): void {
      if (this.#emitting || !this.#written.has(name)) return;
      const value = this.#written.get(name);
      this.#written.delete(name);
      this.binding.event(name, fromX3DOM(type.fields[name], value));
    }

    /** A prototype hands over the nodes of a field by x3dom's list of them. */
    override nodeChanged(name?: string): void {
      super.nodeChanged(name);
      if (name === undefined || !type.fields[name] || !holdsNodes(type.fields[name])) return;
      const { nodes, node } = this._cf[name] ?? {};
      this.binding.set(name, fromX3DOM(type.fields[name], nodes ?? (node ? [node] : [])));
    }

    /** A circle of ROUTEs ends here: one event per field and time stamp. */
    override postMessage(field: string, value: unknown): void {
      if (this.#busy) return;
      this.#busy = true;
      try {
        super.postMessage(field, value);
      } finally {
        this.#busy = false;
      }
    }

    emit(field: string, value: unknown): void {
      this.#emitting = true;
      try {
        this.postMessage(field, toX3DOM(type.fields[field], value, x));
      } finally {
        this.#emitting = false;
        this.#written.clear();
      }
    }

    get routedFields(): readonly string[] {
      if (isListenedTo(this)) return outputsOf(type);
      // What a prototype's field IS has no ROUTE of its own.
      if (this.inPrototype)
        return Object.keys(this._fieldWatchers).filter((name) => name in type.fields);
      return (this.#routed ??= fieldsOfRoutes(this._routes, type));
    }

    get inPrototype(): boolean {
      const host = this.element && ownBinding(this.element)?.scope?.host;
      return !!host && nodeOf(host)?.protoBodyClone !== undefined;
    }

    override setupRoute(field: string, to: X3DNode, toField: string): void {
      super.setupRoute(field, to, toField);
      this.#routed = undefined;
      if (this.element) listener.routed(this);
    }

    override removeRoute(field: string, to: X3DNode, toField: string): void {
      super.removeRoute(field, to, toField);
      this.#routed = undefined;
    }
  };
}

/** Bodies, joints and the like draw nothing, and neither do their children; those are nodes all the same. */
function undrawn(base: X3DNodeClass): X3DNodeClass {
  return class extends base {
    override addChild(): boolean {
      return false;
    }
  };
}

/** A collidable draws its shape wherever it stands in the scene. */
function drawnAsTransform(base: X3DNodeClass, x: X3DOM): X3DNodeClass {
  return class extends base {
    constructor(context: NodeContext) {
      super(context);
      this._trafo = x.fields.SFMatrix4f.identity();
    }

    /**
     * Any containerField is a child to draw; but the Transform that X3DOM's older dialect names by USE stands
     * elsewhere in the scene and is drawn there.
     */
    override addChild(child: X3DNode): boolean | undefined {
      const named =
        child._xmlNode &&
        isTransform(child._xmlNode) &&
        child._xmlNode.parentElement !== this._xmlNode;
      return named ? false : super.addChild(child);
    }
  };
}

const isCollidable = (type: NodeType): boolean => type.name.startsWith('Collidable');

let tell: ((types: Iterable<NodeType>) => void) | undefined;

/** Tells x3dom of both spellings of every physics node. */
export function registerNodeTypes(x: X3DOM, listener: Listener): void {
  tell = (types) => {
    for (const type of types) {
      const base = isCollidable(type)
        ? drawnAsTransform(x.nodeTypes.X3DTransformNode, x)
        : undrawn(x.nodeTypes.X3DChildNode);
      register(x, type.name, tagOf(type), makeType(base, type, x, listener));
    }
  };
  tell(knownTypes());
  watchRoutes(x);
  watchTransforms(x, listener);
  watchUses(x, listener);
  watchInlines(x, listener);
  surviveLostContext(x);
}

/** Types that come in a chunk, and with them their tags. */
export function learnTypes(types: Readonly<Record<string, NodeType>>): void {
  addTypes(types);
  tell?.(Object.values(types));
}

function register(x: X3DOM, name: string, tag: string, type: X3DNodeClass): void {
  x.registerNodeType(name, 'RigidBodyPhysics', type);
  x.registerNodeType(tag, 'RigidBodyPhysics', type);
  type._typeName = name;
}

interface InlineNode extends X3DNode {
  fireEvents(type: string): void;
  /** `scene`: what there is of a file that could be read. */
  loadX3D(scene: Element | null | undefined, space: unknown): void;
}

/** An Inline fires `load` when its file stands in the scene, `error` when no address is left, and neither of a file without a Scene. */
function watchInlines(x: X3DOM, listener: Listener): void {
  const prototype = x.nodeTypes.Inline.prototype as InlineNode;
  const { fireEvents } = prototype;
  prototype.fireEvents = function (this: X3DNode, type: string): void {
    fireEvents.call(this, type);
    if (this._xmlNode) listener.inlineSettled(this._xmlNode, type === 'load');
  };
  const { loadX3D } = prototype;
  prototype.loadX3D = function (this: X3DNode, scene, space): void {
    loadX3D.call(this, scene, space);
    if (!scene && this._xmlNode) listener.inlineSettled(this._xmlNode, false);
  };
}
