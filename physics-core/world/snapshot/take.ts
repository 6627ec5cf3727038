import { forces } from '../../effects/flight/forces.js';
import { jointSolve } from '../../effects/joints/effects.js';
import { resting } from '../../effects/rest/resting.js';
import type { Pose } from '../../base/math.js';
import type { LevelName } from '../../dynamics/levels.js';
import type { Value } from '../../fields/types.js';
import { BodyNode } from '../../nodes/body/body.js';
import { isJoint } from '../../nodes/joints/is-joint.js';
import type { JointNode } from '../../nodes/joints/joint.js';
import type { NodeWorld } from '../../nodes/node/node-world.js';
import { PhysicsNode } from '../../nodes/node/node.js';
import {
  cloned,
  isKept,
  type BodyState,
  type NodeState,
  type Reference,
  type Snapshot,
} from './snapshot.js';

/** The world that a snapshot is taken of. */
interface SnapshotWorld extends NodeWorld {
  readonly accuracy: LevelName;
}

export function takeSnapshot(world: SnapshotWorld): Snapshot {
  world.flush();
  const nodes = [...world.nodes];
  const children = new Set(nodes.flatMap((node) => node.children.all));
  return {
    x3dPhysics: 1,
    time: world.time,
    sinceLook: world.registry.find(resting)?.sinceLook ?? 0,
    level: world.accuracy,
    origin: [...world.poses.origin],
    nodes: nodes.map((node) => stateOf(node, children.has(node))),
  };
}

function stateOf(node: PhysicsNode, child: boolean): NodeState {
  const { asked, authored, beforeEvent } = node.fieldState;
  const lasting = ([name]: [string, Value]): boolean => {
    const field = node.type.fields[name]!;
    return !isKept(field) && field.access !== 'inputOnly';
  };
  const encoded = (values: Map<string, Value>): [string, unknown][] =>
    [...values].filter(lasting).map(([name, value]) => [name, encode(value)]);
  return {
    id: node.id,
    type: node.type.name,
    name: node.name,
    version: node.version,
    collection: node.collection?.id,
    heard: node.heardEvents,
    child,
    asked: encoded(asked),
    // What was only sent in is spent.
    authored: [...authored].filter((name) => node.type.fields[name]!.access !== 'inputOnly'),
    beforeEvent: encoded(beforeEvent),
    ...(node instanceof BodyNode && { start: structuredClone(node.motion.start) }),
    ...(node instanceof BodyNode && node.built ? { body: bodyState(node) } : {}),
    ...(isJoint(node) && node.placed ? { joint: framesOf(node) } : {}),
  };
}

const framesOf = ({ frame1, frame2 }: JointNode): { frame1: Pose; frame2: Pose } =>
  structuredClone({ frame1, frame2 });

function encode(value: Value): unknown {
  if (value instanceof PhysicsNode) return { nodeId: value.id } satisfies Reference;
  return Array.isArray(value) ? value.map(encode) : cloned(value);
}

function bodyState(body: BodyNode): BodyState {
  const { bodies, registry: effects } = body.world;
  return {
    pose: body.pose(),
    velocity: [...bodies.velocityOf(body)],
    asleep: body.sleeping,
    parked: body.presence.parked,
    rest: effects.find(resting)?.save(body.slot) ?? NEVER_QUIET,
    lastStep: effects.find(jointSolve)?.lastStep(body) ?? 0,
    load: structuredClone(effects.find(forces)?.pending(body)),
  };
}

/** Of a body whose rest nobody looks after. */
const NEVER_QUIET = { quiet: 0, anchor: [] };
