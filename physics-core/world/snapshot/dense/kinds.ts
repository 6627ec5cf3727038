import { inRuns, runsOf } from './runs.js';
import type { Pose } from '../../../base/math.js';
import type { Value } from '../../../fields/types.js';
import { BodyNode } from '../../../nodes/body/body.js';
import { PhysicsNode } from '../../../nodes/node/node.js';
import type { NodesWorld } from '../dense.js';
import { columnOf, valuesIn } from './columns.js';
import {
  isLasting,
  isReference,
  type Column,
  type NodeKind,
  type NodeState,
  type Reference,
} from '../snapshot.js';

/** What was said of a world's nodes, word by word, when they were gone over last, and what came of it. */
const known = new WeakMap<object, { said: readonly unknown[]; kinds: NodeKind[] }>();

/** In the order of their first nodes; the same ones as long as nobody says anything else. */
export function kindsOf(world: NodesWorld): NodeKind[] {
  const said = saidOf(world.nodes);
  const last = known.get(world);
  if (last?.said.length === said.length && last.said.every((word, i) => word === said[i]))
    return last.kinds;
  const kinds = inKinds(world.nodes);
  known.set(world, { said, kinds });
  return kinds;
}

function saidOf(nodes: Iterable<PhysicsNode>): unknown[] {
  const said: unknown[] = [];
  for (const node of nodes) {
    const { asked, authored, beforeEvent } = node.fieldState;
    said.push(node, node.name, node.collection, (node as Partial<BodyNode>).motion?.start);
    for (const name of authored) said.push(name);
    for (const [name, value] of asked) said.push(name, value);
    for (const [name, value] of beforeEvent) said.push(name, value);
  }
  return said;
}

function inKinds(nodes: Iterable<PhysicsNode>): NodeKind[] {
  const kinds = new Map<string, PhysicsNode[]>();
  const children = new Set<PhysicsNode>();
  for (const node of nodes) {
    for (const child of node.children.all) children.add(child);
    const key = keyOf(node, children.has(node));
    const kind = kinds.get(key);
    if (kind) kind.push(node);
    else kinds.set(key, [node]);
  }
  return Array.from(kinds.values(), (kind) => kindOf(kind, children.has(kind[0]!)));
}

function keyOf({ id, type, version, collection, fieldState }: PhysicsNode, child: boolean): string {
  const { asked, authored, beforeEvent } = fieldState;
  let key = `${type.name} ${version} ${collection?.id} ${child}`;
  for (const name of asked.keys()) key += ' ' + name;
  for (const name of authored) key += ',' + name;
  // Few nodes have these.
  return beforeEvent.size > 0 ? key + id : key;
}

function kindOf(nodes: readonly PhysicsNode[], child: boolean): NodeKind {
  const [{ type, version, collection, fieldState }] = nodes as [PhysicsNode];
  const asked = columnsOf(nodes, 'asked');
  const authored = [...fieldState.authored].filter(
    (name) => type.fields[name]!.access !== 'inputOnly',
  );
  return {
    type: type.name,
    version,
    ...(collection && { collection: collection.id }),
    ...(child && { child }),
    // What was only sent in is spent; mostly authors wrote just what is asked.
    ...(String(authored) !== String(Object.keys(asked)) && { authored }),
    ids: runsOf(nodes.map(({ id }) => id)),
    names: columnOf(nodes.map(({ name }) => name)),
    ...(nodes[0] instanceof BodyNode && {
      starts: columnOf(nodes.map((node) => (node as BodyNode).motion.start)),
    }),
    asked,
    ...(fieldState.beforeEvent.size > 0 && { beforeEvent: columnsOf(nodes, 'beforeEvent') }),
  };
}

function columnsOf(
  nodes: readonly PhysicsNode[],
  which: 'asked' | 'beforeEvent',
): Record<string, Column> {
  const { type, fieldState } = nodes[0]!;
  const columns: Record<string, Column> = {};
  for (const name of fieldState[which].keys()) {
    const field = type.fields[name]!;
    if (!isLasting(field)) continue;
    const values = nodes.map((node) => {
      const value = node.fieldState[which].get(name);
      return field.nodes ? encoded(value, node.id) : value;
    });
    columns[name] = columnOf(values);
  }
  return columns;
}

/** Nodes by how their ids differ from that of who names them: made alike, they do so alike. */
function encoded(value: Value, id: number): unknown {
  if (Array.isArray(value)) return value.map((item) => encoded(item as Value, id));
  return value instanceof PhysicsNode ? ({ nodeId: value.id - id } satisfies Reference) : value;
}

function decoded(value: unknown, id: number): unknown {
  if (Array.isArray(value)) return value.map((item) => decoded(item, id));
  return isReference(value) ? { nodeId: value.nodeId + id } : value;
}

/** Node by node, in the order of their ids. */
export const statesIn = (kinds: readonly NodeKind[]): NodeState[] =>
  kinds.flatMap(statesOf).sort((a, b) => a.id - b.id);

function statesOf(kind: NodeKind): NodeState[] {
  const { type, version, collection, child, authored } = kind;
  const ids = inRuns(kind.ids);
  const valuesOf = (column: Column): unknown[] => valuesIn(column, ids.length);
  const names = valuesOf(kind.names) as (string | null)[];
  const starts = valuesOf(kind.starts ?? { all: undefined }) as (Pose | null)[];
  const rows = (columns: Record<string, Column>): ((row: number) => [string, unknown][]) => {
    const all = Object.entries(columns).map(([name, column]) => [name, valuesOf(column)] as const);
    return (row) => all.map(([name, values]) => [name, decoded(values[row], ids[row]!)]);
  };
  const asked = rows(kind.asked);
  const beforeEvent = rows(kind.beforeEvent ?? {});
  return ids.map((id, row) => {
    const name = names[row];
    const start = starts[row];
    return {
      id,
      type,
      version,
      ...(name && { name }),
      ...(collection !== undefined && { collection }),
      ...(child && { child }),
      ...(start && { start }),
      asked: asked(row),
      ...(authored && { authored }),
      beforeEvent: beforeEvent(row),
    };
  });
}
