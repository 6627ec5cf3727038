import type { Target } from '../drawing/drawing.js';
import type { Binding } from '../nodes/binding.js';
import type { X3DNode } from '../x3dom/x3dom.js';
import type { provide } from './batch-code.js';
import type { DrawnScene, Drawer } from './drawer.js';
import { LEAST } from './least.js';

/** The first one that is drawn in a node, which may stand in groups there. */
function geometryIn({ _cf, _childNodes }: X3DNode): X3DNode | null | undefined {
  if (_cf.geometry) return _cf.geometry.node;
  for (const child of _childNodes) {
    const geometry = geometryIn(child);
    if (geometry) return geometry;
  }
  return undefined;
}

/** Bodies that look alike are drawn in one call. What does that is loaded with the first eight of one geometry. */
export class Batching {
  readonly #scene: DrawnScene;
  readonly #counted = new WeakSet<X3DNode>();
  readonly #counts = new Map<unknown, number>();
  drawer: Drawer | undefined;

  constructor(scene: DrawnScene) {
    this.#scene = scene;
  }

  /** What a body moves came, or is to be looked at anew. */
  note(node: X3DNode, target: Target, body: Binding): void {
    if (this.drawer) return this.drawer.note(node, target, body);
    if (this.#counted.has(node)) return;
    this.#counted.add(node);
    const geometry = geometryIn(node);
    const count = (this.#counts.get(geometry?.constructor) ?? 0) + 1;
    this.#counts.set(geometry?.constructor, count);
    if (geometry && count === LEAST) void this.#load(body);
  }

  async #load(body: Binding): Promise<void> {
    try {
      const code: { provide: typeof provide; bytes?: number } = await import('./batch-code.js');
      this.drawer ??= code.provide(this.#scene, code.bytes ?? 0);
    } catch (error) {
      body.problem({ code: 'drawing-plain', severity: 'info', message: String(error) });
    }
  }
}
