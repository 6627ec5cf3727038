import { forces } from '../../effects/flight/forces.js';
import { jointSolve } from '../../effects/joints/effects.js';
import { resting } from '../../effects/rest/resting.js';
import { BodyNode } from '../../nodes/body/body.js';
import { isJoint } from '../../nodes/joints/is-joint.js';
import { FieldState } from '../../nodes/node/field-state.js';
import type { PhysicsNode } from '../../nodes/node/node.js';
import type { Lookup } from './lookup.js';
import { isKept, type BodyState } from './snapshot.js';

/** What is asked of its fields. */
export function loadNode(node: PhysicsNode, found: Lookup): void {
  const state = found.states.get(node.id);
  if (node.removed) return;
  if (!state) {
    node.forgetEvents();
    return;
  }
  const fields = new FieldState();
  for (const [name, value] of node.fieldState.asked)
    if (isKept(node.type.fields[name]!)) fields.asked.set(name, value);
  for (const [name, value] of state.asked) fields.asked.set(name, found.decode(value));
  for (const name of state.authored) fields.authored.add(name);
  for (const [name, value] of state.beforeEvent) fields.beforeEvent.set(name, found.decode(value));
  node.load(fields);
  if (isJoint(node)) node.kept = structuredClone(state.joint);
}

/** What stands in Bullet. `slept`: those that were asleep before, and are not said to fall asleep. */
export function loadState(node: PhysicsNode, found: Lookup, slept?: ReadonlySet<BodyNode>): void {
  if (isJoint(node)) node.kept = undefined;
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
  body.motion.place(state.pose);
  body.body.setLinearVelocity(scratch.vector(vx, vy, vz));
  body.body.setAngularVelocity(scratch.vector(wx, wy, wz));
  world.bodies.readVelocity(body);
  if (state.lastStep > 0) world.registry.get(jointSolve).setLastStep(body, state.lastStep);
  if (state.load) world.registry.get(forces).push(body, state.load.force, state.load.torque);
  if (state.parked) body.presence.park();
  else if (!state.asleep) body.wake();
  else if (slept) world.bodies.restoreSleep(body);
  else body.sleep();
  world.registry.find(resting)?.load(body, state.rest);
}
