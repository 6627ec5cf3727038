import type { LevelName } from '../../dynamics/levels.js';
import type { Value } from '../../fields/types.js';
import { BodyNode } from '../../nodes/body/body.js';
import { isJoint } from '../../nodes/joints/is-joint.js';
import { PhysicsNode } from '../../nodes/node/node.js';
import { extentOf } from './check.js';
import { takeBodies, type BodiesWorld } from './bodies.js';
import {
  cloned,
  FORMAT,
  isLasting,
  type NodeState,
  type Reference,
  type Snapshot,
} from './snapshot.js';

/** The world that a snapshot is taken of. */
interface SnapshotWorld extends BodiesWorld {
  readonly accuracy: LevelName;
  readonly control: { readonly parts: number };
}

export function takeSnapshot(world: SnapshotWorld): Snapshot {
  world.flush();
  const nodes = [...world.nodes];
  const children = new Set(nodes.flatMap((node) => node.children.all));
  const snapshot: Omit<Snapshot, 'extent'> = {
    x3dPhysics: FORMAT,
    time: world.time,
    taken: world.stepsTaken,
    level: world.accuracy,
    parts: world.control.parts,
    origin: [...world.poses.origin],
    nodes: nodes.map((node) => stateOf(node, children.has(node))),
    ...takeBodies(world),
    effects: world.registry.save(),
  };
  return { ...snapshot, extent: extentOf(snapshot) };
}

function stateOf(node: PhysicsNode, child: boolean): NodeState {
  const { asked, authored, beforeEvent } = node.fieldState;
  const lasting = ([name]: [string, Value]): boolean => isLasting(node.type.fields[name]!);
  const encoded = (values: Map<string, Value>): [string, unknown][] =>
    [...values].filter(lasting).map(([name, value]) => [name, encode(value)]);
  const said = encoded(asked);
  const before = encoded(beforeEvent);
  const written = [...authored].filter((name) => node.type.fields[name]!.access !== 'inputOnly');
  const heard = node.heardEvents;
  return {
    id: node.id,
    type: node.type.name,
    name: node.name,
    version: node.version,
    collection: node.collection?.id,
    ...(heard.length > 0 && { heard }),
    ...(child && { child }),
    asked: said,
    // What was only sent in is spent; mostly authors wrote just what is asked.
    ...(String(written) !== String(said.map(([name]) => name)) && { authored: written }),
    ...(before.length > 0 && { beforeEvent: before }),
    ...(node instanceof BodyNode && { start: structuredClone(node.motion.start) }),
    ...(isJoint(node) && node.placed ? { joint: node.save() } : {}),
  };
}

function encode(value: Value): unknown {
  if (value instanceof PhysicsNode) return { nodeId: value.id } satisfies Reference;
  return Array.isArray(value) ? value.map(encode) : cloned(value);
}
