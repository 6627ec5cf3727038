import type { Numbered } from '../../effects/effect/effect.js';
import type { BodyNode } from '../../nodes/body/body.js';
import { isJoint } from '../../nodes/joints/is-joint.js';
import { UNMET } from '../../nodes/joints/placed-joint.js';
import type { Stop } from '../../dynamics/joint.js';
import { FieldState } from '../../nodes/node/field-state.js';
import type { PhysicsNode } from '../../nodes/node/node.js';
import { loadBodies, type BodiesWorld } from './bodies.js';
import type { Lookup } from './lookup.js';
import { authoredIn, isKept, type Moment, type Snapshot } from './snapshot.js';

/** What is asked of its fields. `elsewhere`: at another level, at which joints have other rows. */
export function loadNode(node: PhysicsNode, found: Lookup, elsewhere = false): void {
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
  for (const name of authoredIn(state)) fields.authored.add(name);
  for (const [name, value] of state.beforeEvent ?? [])
    fields.beforeEvent.set(name, found.decode(value));
  node.load(fields);
  const joint = found.joints.get(node.id);
  if (!isJoint(node) || !joint) return;
  const { rows, ...zero } = structuredClone(joint);
  node.kept = elsewhere ? zero : { ...zero, rows };
}

/** What the next step asks of those before it: bodies, what touches, and what effects know. */
export function loadState(
  world: BodiesWorld,
  { effects }: Snapshot,
  moment: Moment,
  slept?: ReadonlySet<BodyNode>,
): void {
  for (const node of world.nodes)
    if (isJoint(node)) {
      const stops = node.kept?.rows?.stops;
      node.stops.forEach((stop, i) => (stop.at = metAt(stops?.[i])));
      node.kept = undefined;
    }
  loadBodies(world, moment, slept);
  world.registry.load(effects, numbered(world));
}

const metAt = (at = UNMET): Stop['at'] => (at === UNMET ? undefined : (at as Stop['at']));

function numbered({ bodies, nodes }: BodiesWorld): Numbered {
  const byId = new Map([...bodies].map((body) => [body.id, body]));
  const joints = new Map([...nodes].filter(isJoint).map((joint) => [joint.id, joint]));
  return { body: (id) => byId.get(id), joint: (id) => joints.get(id) };
}
