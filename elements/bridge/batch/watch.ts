import type { X3DNode } from '../x3dom/x3dom.js';
import type { X3DShape } from '../x3dom/renderer.js';
import { appearanceOf, geometryOf } from './look.js';
import type { Member } from './member.js';
import { ownMesh } from './meshes.js';

// Nobody can ask x3dom what changed. It calls these methods of a node whenever something did; the ones that are put in
// their place on the node itself tell of it, too.

type Method =
  | 'fieldChanged'
  | 'nodeChanged'
  | 'parentAdded'
  | 'parentRemoved'
  | 'addChild'
  | 'removeChild'
  | 'highlight';
type Methods = Record<Method, (...args: unknown[]) => unknown>;

const OF_A_GROUP = [
  'fieldChanged',
  'nodeChanged',
  'parentAdded',
  'parentRemoved',
  'addChild',
  'removeChild',
] as const;

/** Hears of all that decides how a member is drawn; of what several share once for all of them. */
export class Watch {
  readonly #members: ReadonlyMap<X3DNode, Member>;
  readonly #onchange: (member: Member) => void;
  readonly #watched = new WeakSet<X3DNode>();
  /** Whose own group a node was last. */
  readonly #around = new WeakMap<X3DNode, Member>();

  constructor(members: ReadonlyMap<X3DNode, Member>, onchange: (member: Member) => void) {
    this.#members = members;
    this.#onchange = onchange;
  }

  begin(member: Member): void {
    const { shape, strand } = member;
    for (const node of strand.nodes) {
      this.#around.set(node, member);
      this.#hear(node, ...OF_A_GROUP);
    }
    if (!shape) return;
    if (this.#hear(shape, 'fieldChanged', 'nodeChanged')) this.#hearFlags(shape);
    const geometry = geometryOf(shape);
    if (geometry && this.#hear(geometry, 'fieldChanged')) this.#keepMesh(geometry);
    const appearance = appearanceOf(shape);
    if (appearance) this.#hear(appearance, 'fieldChanged');
    const material = appearance?._cf.material.node;
    if (material) this.#hear(material, 'highlight');
  }

  /** False where it was heard of before. */
  #hear(node: X3DNode, ...names: Method[]): boolean {
    if (this.#watched.has(node)) return false;
    this.#watched.add(node);
    const own = node as unknown as Methods;
    for (const name of names) {
      const method = own[name];
      own[name] = (...args) => {
        const result = method.apply(node, args);
        this.#touch(node);
        return result;
      };
    }
    return true;
  }

  #hearFlags(shape: X3DShape): void {
    const flags = new Flags(shape._dirty, () => this.#touch(shape));
    shape._dirty = flags as unknown as Record<string, boolean>;
  }

  /** It gets a mesh of its own before x3dom writes into the one that it shares. */
  #keepMesh(geometry: X3DNode): void {
    const { fieldChanged } = geometry;
    geometry.fieldChanged = (name) => {
      geometry._mesh = ownMesh(geometry);
      geometry.fieldChanged = fieldChanged;
      fieldChanged.call(geometry, name);
    };
  }

  /** The members that a node is a part of. */
  #touch(node: X3DNode): void {
    const member = this.#members.get(node) ?? this.#around.get(node);
    if (member) this.#onchange(member);
    else for (const parent of node._parentNodes) this.#touch(parent);
  }
}

/** What x3dom is to bring to WebGL anew: it sets these flags at a Shape where anything below it changed. */
const FLAGS = [
  'positions',
  'normals',
  'texcoords',
  'colors',
  'tangents',
  'binormals',
  'specialAttribs',
  'indexes',
  'texture',
  'material',
  'text',
  'shader',
  'ids',
];

class Flags {
  readonly values: Record<string, boolean>;
  readonly told: () => void;

  constructor(values: Record<string, boolean>, told: () => void) {
    this.values = { ...values };
    this.told = told;
  }
}

for (const name of FLAGS)
  Object.defineProperty(Flags.prototype, name, {
    get(this: Flags) {
      return this.values[name];
    },
    set(this: Flags, on: boolean) {
      this.values[name] = on;
      if (on) this.told();
    },
  });
