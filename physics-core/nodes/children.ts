import type { Value } from '../fields/types.js';
import { PhysicsNode, type NodeData } from './node.js';
import type { Field } from './table.js';

/** Nodes made from plain data given to the fields of a node; they live and die with it. */
export class Children {
  readonly #parent: PhysicsNode;
  readonly #byField = new Map<string, PhysicsNode[]>();

  constructor(parent: PhysicsNode) {
    this.#parent = parent;
  }

  /** Plain data in a node field becomes nodes of our own, in the place of those it had. */
  adopt(name: string, field: Field, value: Value): Value {
    if (!field.nodes) return value;
    const stays = (child: PhysicsNode): boolean => [value].flat().includes(child);
    const before = this.#byField.get(name) ?? [];
    for (const child of before) if (!stays(child)) child.remove();
    const made = before.filter(stays);
    const node = (item: unknown): unknown => {
      if (item instanceof PhysicsNode || item === null || typeof item !== 'object') return item;
      const child = this.#parent.world.addData(item as NodeData, this.#parent, field.nodes!);
      if (child instanceof PhysicsNode) made.push(child);
      return child;
    };
    const adopted = Array.isArray(value) ? value.map(node).filter(Boolean) : node(value);
    this.#byField.set(name, made);
    return adopted;
  }

  get all(): PhysicsNode[] {
    return [...this.#byField.values()].flat();
  }

  remove(): void {
    for (const children of this.#byField.values()) for (const child of children) child.remove();
  }
}
