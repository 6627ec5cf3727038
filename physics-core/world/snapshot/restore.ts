import type { Engine } from '../../engine/engine.js';
import type { PhysicsNode } from '../../nodes/node/node.js';
import type { LevelControl } from '../accuracy/level-control.js';
import type { Lifecycle } from '../lifecycle/lifecycle.js';
import type { Stepping } from '../stepping/stepping.js';
import type { AddOptions } from '../store/types.js';
import type { LevelName } from '../../dynamics/levels.js';
import { isJoint } from '../../nodes/joints/is-joint.js';
import type { BodiesWorld } from './bodies.js';
import { loadNode, loadState } from './load.js';
import { Lookup } from './lookup.js';
import { isSame } from './same.js';
import { faultOf } from './check.js';
import type { Snapshot } from './snapshot.js';

/** The world that goes back to a snapshot, or becomes one. */
interface RestoredWorld extends BodiesWorld {
  readonly accuracy: LevelName;
  add(type: string, fields: Record<string, unknown>, options: AddOptions): PhysicsNode;
  set(field: string, value: unknown): void;
  readonly lifecycle: Lifecycle;
  readonly stepping: Stepping;
  readonly control: LevelControl;
}

export function restoreSnapshot(world: RestoredWorld, snapshot: Snapshot): void {
  if (!world.started || !isSnapshot(world, snapshot)) return;
  world.flush();
  const tellWoken = world.bodies.sleepers();
  const slept = new Set([...world.bodies].filter((body) => body.sleeping));
  if (isSame(world, snapshot)) begin(world, snapshot);
  else rebuild(world, snapshot);
  world.stepping.resume(snapshot.time, snapshot.taken);
  loadState(world, snapshot, slept);
  tellWoken();
  world.emit('restore', world);
}

/** All that is made stays. */
function begin(world: RestoredWorld, { nodes }: Snapshot): void {
  world.registry.reset('reset');
  world.bodies.forgetSleep();
  const states = new Map(nodes.map((state) => [state.id, state]));
  for (const node of world.nodes) if (isJoint(node)) node.kept = states.get(node.id)?.joint;
}

function rebuild(world: RestoredWorld, snapshot: Snapshot): void {
  const found = new Lookup(world.nodes, snapshot, goneIn(world));
  world.bodies.countFrom(snapshot.origin);
  world.lifecycle.rebuild(() => {
    world.control.begin(snapshot.level);
    for (const node of [...world.nodes]) loadNode(node, found);
  });
  world.bodies.countFrom(undefined);
}

/**
 * Makes an empty world as the one a snapshot was taken of, in any engine: what it needs is all plain data. In pieces, so
 * that nobody need be held up: each `next` goes on by one node. `settings`: fields of its collection that are others here.
 */
export function* copyInto(
  world: RestoredWorld,
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
  const found = new Lookup(world.nodes, snapshot, goneIn(world));
  const elsewhere = Object.keys(settings).length > 0;
  for (const { id, heard, collection } of snapshot.nodes) {
    // It may have been born after those that belong to it.
    if (collection !== undefined) born.get(id)!.collection = born.get(collection);
    loadNode(born.get(id)!, found, elsewhere);
    for (const event of heard ?? []) born.get(id)!.on(event, () => {});
    yield;
  }
  for (const [name, value] of Object.entries(settings)) world.set(name, value);
  world.control.begin(snapshot.level);
  world.bodies.countFrom(snapshot.origin);
  yield* world.lifecycle.starting(engine);
  world.bodies.countFrom(undefined);
  world.stepping.resume(snapshot.time, snapshot.taken);
  loadState(world, snapshot);
}

const goneIn = (world: RestoredWorld) => (id: number) => {
  const gone = world.add('RigidBody', {}, { id });
  gone.remove();
  return gone;
};

function isSnapshot(world: RestoredWorld, snapshot: Snapshot): boolean {
  const fault = faultOf(snapshot, world.nodes);
  if (fault === undefined) return true;
  world.report({
    code: 'bad-value',
    severity: 'warning',
    attribute: 'restore',
    value: snapshot,
    used: 'nothing',
    message: `${fault}; nothing is restored`,
  });
  return false;
}
