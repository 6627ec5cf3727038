import type { X3DNode } from '../x3dom/x3dom.js';
import type { X3DShape } from '../x3dom/renderer.js';

// Nobody can ask x3dom what changed. It calls these methods of a node whenever something did; the ones that are put in
// their place on the node itself tell of it, too.

export type Method = 'fieldChanged' | 'nodeChanged' | 'parentAdded' | 'parentRemoved' | 'highlight';

type Methods = Record<Method, (...args: unknown[]) => void>;

export function watch(node: X3DNode, told: () => void, ...methods: Method[]): void {
  const own = node as unknown as Methods;
  for (const name of methods) {
    const method = own[name];
    own[name] = (...args) => {
      method.apply(node, args);
      told();
    };
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

export function watchFlags(shape: X3DShape, told: () => void): void {
  shape._dirty = new Flags(shape._dirty, told) as unknown as Record<string, boolean>;
}
