import type { Value } from '../../fields/types.js';
import { BodyNode } from '../../nodes/body/body.js';
import { isJoint } from '../../nodes/joints/is-joint.js';
import { PhysicsNode } from '../../nodes/node/node.js';
import { dense, type NodesWorld } from './dense.js';
import {
  cloned,
  isLasting,
  type NodeKind,
  type NodeState,
  type Reference,
  type Snapshot,
} from './snapshot.js';

const isDense = (nodes: Snapshot['nodes']): nodes is NodeKind[] => 'ids' in (nodes[0] ?? {});

/** What is asked of the nodes of a world; `like`: to be compared with. */
export function nodesOf(world: NodesWorld, like?: Snapshot['nodes']): Snapshot['nodes'] {
  if (dense.here && (!like || isDense(like))) return dense.code.kindsOf(world);
  const nodes = [...world.nodes];
  const children = new Set(nodes.flatMap((node) => node.children.all));
  return nodes.map((node) => stateOf(node, children.has(node)));
}

/** Of joints that are placed. */
export const jointsOf = ({ nodes }: NodesWorld): Snapshot['joints'] =>
  [...nodes].flatMap((node) => (isJoint(node) && node.placed ? [[node.id, node.save()]] : []));

/** Node by node. */
export const statesIn = ({ nodes }: Pick<Snapshot, 'nodes'>): NodeState[] =>
  isDense(nodes) ? dense.code.statesIn(nodes) : nodes;

function stateOf(node: PhysicsNode, child: boolean): NodeState {
  const { id, type, name, version, collection } = node;
  const { asked, authored, beforeEvent } = node.fieldState;
  const encoded = (values: Map<string, Value>): [string, unknown][] =>
    [...values]
      .filter(([name]) => isLasting(type.fields[name]!))
      .map(([name, value]) => [name, encode(value) ?? null]);
  const said = encoded(asked);
  const before = encoded(beforeEvent);
  const written = [...authored].filter((name) => type.fields[name]!.access !== 'inputOnly');
  const start = node instanceof BodyNode && node.motion.start;
  return {
    id,
    type: type.name,
    version,
    ...(name && { name }),
    ...(collection && { collection: collection.id }),
    ...(child && { child }),
    asked: said,
    // What was only sent in is spent; mostly authors wrote just what is asked.
    ...(String(written) !== String(said.map(([name]) => name)) && { authored: written }),
    ...(before.length > 0 && { beforeEvent: before }),
    ...(start && { start: cloned(start) }),
  };
}

function encode(value: Value): unknown {
  if (value instanceof PhysicsNode) return { nodeId: value.id } satisfies Reference;
  return Array.isArray(value) ? value.map(encode) : cloned(value);
}
