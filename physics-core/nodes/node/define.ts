import { boundedFields, nodeFields } from './common-fields.js';
import type { NodeContext } from './node-world.js';
import type { PhysicsNode } from './node.js';
import { USUAL } from '../../fields/usual.js';
import { byName, type Field, type NodeType } from './table.js';

/** A node's table, and how a node of it is made. */
export interface NodeDefinition<N extends PhysicsNode = PhysicsNode> extends NodeType<N> {
  /** Where its code comes in a chunk, that gives it. */
  make?(context: NodeContext): N;
}

/** Whole tables, with the fields that all nodes, or all bounded ones, have. */
export function defineNode<N extends PhysicsNode>(type: NodeDefinition<N>): NodeDefinition<N> {
  const common = { ...(type.bounded ? boundedFields : {}), ...nodeFields };
  const fields: [string, Field<N>][] = Object.entries({ ...type.fields, ...common });
  const whole = fields.map(([name, field]) => [name, { ...USUAL, ...field }]);
  return { ...type, fields: byName(Object.fromEntries(whole)) };
}
