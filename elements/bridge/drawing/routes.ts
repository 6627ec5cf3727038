import { codecs } from '../../../physics-core/index.js';
import type { PhysicsX3DNode } from '../x3dom/node-types.js';
import type { PageWorld } from '../nodes/worlds.js';

/** Sends what the simulation changed to where it is ROUTEd, once per drawn frame. */
export class Routes {
  /** Nodes with outgoing ROUTEs, and the values they sent last. */
  readonly #routed = new Map<PhysicsX3DNode, Map<string, unknown>>();

  add(node: PhysicsX3DNode): void {
    if (!this.#routed.has(node)) this.#routed.set(node, new Map());
  }

  send(world: PageWorld): void {
    for (const [node, sent] of this.#routed) {
      // x3dom makes a new node when an element moves or comes back.
      if (!node._xmlNode) this.#routed.delete(node);
      else if (node.binding.world === world && node.binding.node) this.#sendFrom(node, sent);
    }
  }

  #sendFrom(node: PhysicsX3DNode, sent: Map<string, unknown>): void {
    const { binding } = node;
    for (const name of node.routedFields) {
      const { type } = binding.type.fields[name];
      const value = binding.get(name);
      if (value === undefined) continue;
      const last = sent.get(name);
      if (last !== undefined && codecs[type].equal(last, value)) continue;
      sent.set(name, value);
      node.emit(name, value);
    }
  }
}
