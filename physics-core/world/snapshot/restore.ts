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
import { faultOf } from './check.js';
import { isSame } from './same.js';
import type { Snapshot } from './snapshot.js';

/** The world that goes back to a snapshot, or becomes one. */
export interface RestoredWorld extends BodiesWorld {
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
  becomeAs(world, snapshot);
  tellWoken();
  world.emit('restore', world);
}

/** Nobody is told. */
export function becomeAs(world: RestoredWorld, snapshot: Snapshot): void {
  const slept = new Set([...world.bodies].filter((body) => body.sleeping));
  if (isSame(world, snapshot)) begin(world, snapshot);
  else rebuild(world, snapshot);
  world.stepping.resume(snapshot.time, snapshot.taken);
  loadState(world, snapshot, slept);
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
    world.control.begin(snapshot.level, snapshot.parts);
    for (const node of [...world.nodes]) loadNode(node, found);
  });
  world.bodies.countFrom(undefined);
}

/** Bodies that are there no more, and are named all the same. */
export const goneIn = (world: RestoredWorld) => (id: number) => {
  const gone = world.add('RigidBody', {}, { id });
  gone.remove();
  return gone;
};

function isSnapshot(world: RestoredWorld, snapshot: Snapshot): boolean {
  const fault = faultOf(snapshot, world.nodes, world.bullet.kept);
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
