import type { Collision, CollisionEnd } from '../effects/contacts/touches.js';
import { CollisionSensorNode } from '../nodes/collision/collision-sensor-node.js';
import type { PhysicsNode } from '../nodes/node/node.js';

/** What was told to have begun on the other side, and not to have ended: nobody there tells of it once that is gone. */
export class Begun {
  readonly #touches = new Map<PhysicsNode, Set<unknown>>();
  readonly #active = new Set<CollisionSensorNode>();

  note(node: PhysicsNode, event: string, detail: unknown): void {
    if (node instanceof CollisionSensorNode && event === 'isActive') {
      if (detail) this.#active.add(node);
      else this.#active.delete(node);
    }
    if (event === 'collisionstart') this.#touchesOf(node).add((detail as Collision).other);
    if (event === 'collisionend') this.#ended(node, (detail as Collision).other);
  }

  #touchesOf(node: PhysicsNode): Set<unknown> {
    const known = this.#touches.get(node) ?? new Set();
    this.#touches.set(node, known);
    return known;
  }

  #ended(node: PhysicsNode, other: unknown): void {
    const others = this.#touches.get(node);
    others?.delete(other);
    if (others?.size === 0) this.#touches.delete(node);
  }

  end(reason: CollisionEnd, time: number): void {
    for (const [node, others] of this.#touches)
      for (const other of others)
        node.emit('collisionend', { other, impulse: 0, contacts: [], time, reason });
    this.#touches.clear();
    for (const sensor of this.#active) {
      sensor.show(false, []);
      sensor.emit('isActive', false);
    }
    this.#active.clear();
  }
}
