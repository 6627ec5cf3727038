import type { LevelName } from '../dynamics/levels.js';
import type { Engine } from '../engine/engine.js';
import type { Value, Vec3 } from '../fields/types.js';
import type { Pose } from '../base/math.js';
import { BodyNode } from '../nodes/body.js';
import { JointNode } from '../nodes/joint.js';
import { PhysicsNode } from '../nodes/node.js';
import type { CollectionNode } from '../nodes/rigid-body-collection.js';
import { FieldState } from '../nodes/field-state.js';
import type { Field } from '../nodes/table.js';
import type { World } from './world.js';

/** What a node stands for in a snapshot: its id. */
interface Reference {
  nodeId: number;
}

/** What Bullet and the effects know of a body. */
interface BodyState {
  pose: Pose;
  /** Of the centre of mass, linear then angular. */
  velocity: number[];
  asleep: boolean;
  parked: boolean;
  rest: { quiet: number; anchor: number[] };
  /** Seconds of its last step, to the middle of which joints keep its velocity; 0: to the moment. */
  lastStep: number;
  /** What `applyForce` and `applyTorque` asked of the next step. */
  load: { force: Vec3; torque: Vec3 } | undefined;
}

interface NodeState {
  id: number;
  type: string;
  /** What a node is born with, for those that are made again elsewhere. */
  name: string | undefined;
  version: number;
  collection: number | undefined;
  start?: Pose | undefined;
  /** Events of it that somebody listens to: they switch effects on. */
  heard: string[];
  /** Made from plain data in a field of another. */
  child: boolean;
  asked: [string, unknown][];
  authored: string[];
  beforeEvent: [string, unknown][];
  body?: BodyState;
  /** Where the joint is at zero. */
  joint?: { frame1: Pose; frame2: Pose };
}

/** A world at one moment as plain data. */
export interface Snapshot {
  x3dPhysics: 1;
  time: number;
  sinceLook: number;
  /** The level in force. */
  level: LevelName;
  nodes: NodeState[];
}

// ---- taking --------------------------------------------------------------------------------------------------------

export function takeSnapshot(world: World): Snapshot {
  world.flush();
  const nodes = [...world.nodes];
  const children = new Set(nodes.flatMap((node) => node.children.all));
  return {
    x3dPhysics: 1,
    time: world.time,
    sinceLook: world.registry.resting.sinceLook,
    level: world.accuracy,
    nodes: nodes.map((node) => stateOf(node, children.has(node))),
  };
}

/** What the simulation makes nothing of, whatever it may be, stays where it is. */
const isKept = ({ common, type, nodes }: Field): boolean =>
  common === true || (/^[SM]FNode$/.test(type) && !nodes);

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
    ...(node instanceof BodyNode && { start: structuredClone(node.start) }),
    ...(node instanceof BodyNode && node.built ? { body: bodyState(node) } : {}),
    ...(node instanceof JointNode && node.placed ? { joint: framesOf(node) } : {}),
  };
}

const framesOf = ({ frame1, frame2 }: JointNode): { frame1: Pose; frame2: Pose } =>
  structuredClone({ frame1, frame2 });

function encode(value: Value): unknown {
  if (value instanceof PhysicsNode) return { nodeId: value.id } satisfies Reference;
  return Array.isArray(value) ? value.map(encode) : cloned(value);
}

/** Most values are numbers, which need none. */
const cloned = <T>(value: T): T => (typeof value === 'object' ? structuredClone(value) : value);

function bodyState(body: BodyNode): BodyState {
  const { bodies, registry } = body.world;
  return {
    pose: body.pose(),
    velocity: [...bodies.velocityOf(body)],
    asleep: body.sleeping,
    parked: body.parked,
    rest: registry.resting.save(body.slot),
    lastStep: registry.joints.lastStep(body),
    load: structuredClone(registry.forces.pending(body)),
  };
}

// ---- restoring -----------------------------------------------------------------------------------------------------

export function restoreSnapshot(world: World, snapshot: Snapshot): void {
  if (!world.started || !isSnapshot(world, snapshot)) return;
  world.flush();
  const found = new Lookup(world, snapshot);
  const tellWoken = world.bodies.sleepers();
  const slept = new Set([...world.bodies].filter((body) => body.sleeping));
  world.rebuild(() => {
    world.control.begin(snapshot.level);
    for (const node of [...world.nodes]) loadNode(node, found);
  });
  world.stepping.resume(snapshot.time);
  world.registry.resting.sinceLook = snapshot.sinceLook;
  for (const node of world.nodes) loadState(node, found, slept);
  tellWoken();
  world.emit('restore', world);
}

/**
 * Makes an empty world as the one a snapshot was taken of, in any engine: what it needs is all plain data. In pieces, so
 * that nobody need be held up: each `next` goes on by one node. `settings`: fields of its collection that are others here.
 */
export function* copyInto(
  world: World,
  snapshot: Snapshot,
  engine: Engine,
  settings: Record<string, unknown> = {},
): Generator<void> {
  const born = new Map<number, PhysicsNode>();
  for (const { id, type, name, version, collection, start } of snapshot.nodes) {
    const group = collection === undefined ? undefined : born.get(collection);
    born.set(id, world.add(type, {}, { id, name, version, collection: group, start }));
    yield;
  }
  const found = new Lookup(world, snapshot);
  for (const { id, heard, collection } of snapshot.nodes) {
    // It may have been born after those that belong to it.
    if (collection !== undefined) born.get(id)!.collection = born.get(collection) as CollectionNode;
    loadNode(born.get(id)!, found);
    for (const event of heard) born.get(id)!.on(event, () => {});
    yield;
  }
  for (const [name, value] of Object.entries(settings)) world.set(name, value);
  world.control.begin(snapshot.level);
  yield* world.starting(engine);
  world.stepping.resume(snapshot.time);
  world.registry.resting.sinceLook = snapshot.sinceLook;
  for (const node of world.nodes) {
    loadState(node, found);
    yield;
  }
}

function isSnapshot(world: World, snapshot: Snapshot): boolean {
  if ((snapshot as Snapshot | undefined)?.x3dPhysics === 1) return true;
  world.report({
    code: 'bad-value',
    severity: 'warning',
    attribute: 'restore',
    value: snapshot,
    used: 'nothing',
    message: 'restore takes what snapshot() gave; nothing is done',
  });
  return false;
}

/** The nodes of a world and their states in a snapshot, by id. */
class Lookup {
  readonly states: Map<number, NodeState>;
  readonly #nodes: Map<number, PhysicsNode>;

  constructor(world: World, snapshot: Snapshot) {
    this.states = new Map(snapshot.nodes.map((state) => [state.id, state]));
    this.#nodes = new Map([...world.nodes].map((node) => [node.id, node]));
  }

  /** Nodes for references; a child that went is made again from its data, any other that went is left out. */
  decode(value: unknown): Value {
    if (Array.isArray(value))
      return value.map((item) => this.decode(item)).filter((item) => item !== null);
    return isReference(value) ? this.#node(value.nodeId) : (cloned(value) as Value);
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

const isReference = (value: unknown): value is Reference =>
  typeof value === 'object' && value !== null && 'nodeId' in value;

function loadNode(node: PhysicsNode, found: Lookup): void {
  const state = found.states.get(node.id);
  if (node.removed) return;
  if (!state) {
    node.forgetEvents();
    return;
  }
  const said = new FieldState();
  for (const [name, value] of node.fieldState.asked)
    if (isKept(node.type.fields[name]!)) said.asked.set(name, value);
  for (const [name, value] of state.asked) said.asked.set(name, found.decode(value));
  for (const name of state.authored) said.authored.add(name);
  for (const [name, value] of state.beforeEvent) said.beforeEvent.set(name, found.decode(value));
  node.load(said);
  if (node instanceof JointNode) node.kept = structuredClone(state.joint);
}

/** What stands in Bullet. `slept`: those that were asleep before, and are not said to fall asleep. */
function loadState(node: PhysicsNode, found: Lookup, slept?: ReadonlySet<BodyNode>): void {
  if (node instanceof JointNode) node.kept = undefined;
  const state = found.states.get(node.id)?.body;
  if (node instanceof BodyNode && node.built && state) loadBody(node, state, slept?.has(node));
}

function loadBody(body: BodyNode, state: BodyState, slept = false): void {
  const { world } = body;
  const { scratch } = world.engine;
  const [vx, vy, vz, wx, wy, wz] = state.velocity as [
    number,
    number,
    number,
    number,
    number,
    number,
  ];
  body.place(state.pose);
  body.body.setLinearVelocity(scratch.vector(vx, vy, vz));
  body.body.setAngularVelocity(scratch.vector(wx, wy, wz));
  world.bodies.readVelocity(body);
  if (state.lastStep > 0) world.registry.joints.setLastStep(body, state.lastStep);
  if (state.load) world.push(body, state.load.force, state.load.torque);
  if (state.parked) body.park();
  else if (!state.asleep) body.wake();
  else if (slept) world.bodies.restoreSleep(body);
  else body.sleep();
  world.registry.resting.load(body.slot, state.rest);
}
