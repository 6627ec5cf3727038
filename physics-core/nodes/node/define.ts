import { boundedFields, nodeFields } from './common-fields.js';
import type { NodeContext } from './node-world.js';
import type { PhysicsNode } from './node.js';
import { byName, type NodeType } from './table.js';

/** A node's table, and how a node of it is made. */
export interface NodeDefinition<N extends PhysicsNode = PhysicsNode> extends NodeType<N> {
  /** Where its code comes in a chunk, that gives it. */
  make?(context: NodeContext): N;
}

/** Adds the fields that all nodes, or all bounded ones, have. */
export function defineNode<N extends PhysicsNode>(type: NodeDefinition<N>): NodeDefinition<N> {
  const common = { ...(type.bounded ? boundedFields : {}), ...nodeFields };
  return { ...type, fields: byName({ ...type.fields, ...common }) };
}
