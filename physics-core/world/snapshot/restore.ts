import type { PhysicsNode } from '../../nodes/node/node.js';
import type { LevelControl } from '../accuracy/level-control.js';
import type { Lifecycle } from '../lifecycle/lifecycle.js';
import type { Stepping } from '../stepping/stepping.js';
import type { AddOptions } from '../store/types.js';
import type { LevelName } from '../../dynamics/levels.js';
import { isJoint } from '../../nodes/joints/is-joint.js';
import { momentIn, type BodiesWorld } from './bodies.js';
import { dense } from './dense.js';
import { loadNode, loadState } from './load.js';
import { Lookup } from './lookup.js';
import { faultOf } from './check.js';
import { isSame } from './same.js';
import { nodesOf } from './states.js';
import type { Snapshot } from './snapshot.js';

/** The world that goes back to a snapshot, or becomes one. */
export interface RestoredWorld extends BodiesWorld {
  readonly accuracy: LevelName;
  add(type: string, fields: Record<string, unknown>, options: AddOptions): PhysicsNode;
  set(field: string, value: unknown): void;
  readonly lifecycle: Lifecycle;
  readonly stepping: Stepping;
  readonly control: LevelControl;
  readonly awaiting: { stand(code: Promise<void>, then: () => void): Promise<void> };
}

export function restoreSnapshot(world: RestoredWorld, snapshot: Snapshot): void {
  const now = (): void => restoreNow(world, snapshot);
  // A kept one, of a page that had its code.
  if (typeof snapshot?.bodies === 'string' && !dense.here)
    void world.awaiting.stand(dense.load(), now);
  else now();
}

function restoreNow(world: RestoredWorld, snapshot: Snapshot): void {
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
  const moment = momentIn(snapshot);
  if (isSame(world, snapshot, moment)) begin(world, snapshot);
  else rebuild(world, snapshot);
  world.stepping.resume(snapshot.time, snapshot.taken);
  loadState(world, snapshot, moment, slept);
}

/** All that is made stays. */
function begin(world: RestoredWorld, { joints }: Snapshot): void {
  world.registry.reset('reset');
  world.bodies.forgetSleep();
  const states = new Map(joints);
  for (const node of world.nodes) if (isJoint(node)) node.kept = states.get(node.id);
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
  const fault = faultOf(snapshot, nodesOf(world), world.bullet.kept);
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
