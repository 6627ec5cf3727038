import type { Value } from '../../fields/types.js';
import type { PhysicsNode } from '../../nodes/node/node.js';
import { cloned, isReference, type JointState, type NodeState, type Snapshot } from './snapshot.js';
import { statesIn } from './states.js';

/** The nodes of a world and their states in a snapshot, by id. */
export class Lookup {
  readonly states: Map<number, NodeState>;
  readonly joints: Map<number, JointState>;
  readonly #nodes: Map<number, PhysicsNode>;

  /** Stands for a body that was gone already when the snapshot was taken: its joints hold nothing, and not on to the world. */
  readonly #gone: (id: number) => PhysicsNode;

  constructor(nodes: Iterable<PhysicsNode>, snapshot: Snapshot, gone: (id: number) => PhysicsNode) {
    this.#gone = gone;
    this.states = new Map(statesIn(snapshot).map((state) => [state.id, state]));
    this.joints = new Map(snapshot.joints);
    this.#nodes = new Map([...nodes].map((node) => [node.id, node]));
  }

  /** Nodes for references; a child that went is made again from its data, any other that went is left out. */
  decode(value: unknown): Value {
    if (Array.isArray(value))
      return value
        .filter((item) => !isReference(item) || this.states.has(item.nodeId))
        .map((item) => this.decode(item))
        .filter((item) => item !== null);
    if (!isReference(value)) return cloned(value) as Value;
    return this.states.has(value.nodeId) ? this.#node(value.nodeId) : this.#gone(value.nodeId);
  }

  #node(id: number): Value {
    const node = this.#nodes.get(id);
    if (node && !node.removed) return node;
    const gone = this.states.get(id);
    if (!gone?.child) return null;
    const fields = gone.asked.map(([name, one]) => [name, this.decode(one)]);
    return { type: gone.type, ...Object.fromEntries(fields) };
  }
}
