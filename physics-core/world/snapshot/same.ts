import { BodyNode } from '../../nodes/body/body.js';
import { isJoint } from '../../nodes/joints/is-joint.js';
import { PhysicsNode } from '../../nodes/node/node.js';
import { bytesOf } from '../../base/packed.js';
import { isParked, type BodiesWorld } from './bodies.js';
import { authoredIn, isLasting, type NodeState, type Snapshot } from './snapshot.js';

/** The world that goes back. */
interface SameWorld extends BodiesWorld {
  readonly accuracy: string;
  readonly control: { readonly parts: number };
}

/** Whether all that stands in Bullet is as it was, but for where it is: nothing is to be made anew. */
export function isSame(
  world: SameWorld,
  { level, parts, origin, nodes, bodies }: Snapshot,
): boolean {
  if (
    world.accuracy !== level ||
    world.control.parts !== parts ||
    !alike(world.poses.origin, origin)
  )
    return false;
  const states = new Map(nodes.map((state) => [state.id, state]));
  let count = 0;
  for (const node of world.nodes) {
    const state = states.get(node.id);
    if (!state || !isAsked(node, state) || !isPlaced(node, state)) return false;
    count++;
  }
  if (count !== nodes.length) return false;
  const built = new Map([...world.bodies].map((body) => [body.id, body]));
  const flags = bytesOf(bodies.flags);
  return (
    bodies.ids.length === built.size &&
    bodies.ids.every((id, i) => built.get(id)?.presence.parked === isParked(flags[i]!))
  );
}

/** Whether the same is asked of its fields. */
function isAsked({ type, fieldState }: PhysicsNode, state: NodeState): boolean {
  const { asked, authored, beforeEvent } = fieldState;
  const same = (values: Map<string, unknown>, saved: readonly [string, unknown][]): boolean => {
    let count = 0;
    for (const name of values.keys()) if (isLasting(type.fields[name]!)) count++;
    return count === saved.length && saved.every(([name, value]) => alike(values.get(name), value));
  };
  const written = authoredIn(state);
  return (
    same(asked, state.asked) &&
    same(beforeEvent, state.beforeEvent ?? []) &&
    written.every((name) => authored.has(name)) &&
    [...authored].filter((name) => type.fields[name]!.access !== 'inputOnly').length ===
      written.length
  );
}

/** Whether a joint has its zero where it had it, and the same rows. */
function isPlaced(node: PhysicsNode, { start, joint }: NodeState): boolean {
  if (node instanceof BodyNode) return alike(node.motion.start, start);
  if (!isJoint(node)) return true;
  if (!node.placed || !joint) return !node.placed && !joint;
  const now = node.save();
  const { stops } = joint.rows;
  return (
    stops.length === now.rows.stops.length && alike({ ...now, rows: { ...now.rows, stops } }, joint)
  );
}

/** Whether a value is what stands for it in a snapshot. */
function alike(value: unknown, saved: unknown): boolean {
  if (typeof value !== 'object' || value === null)
    return value === saved || (value === undefined && saved === null);
  if (typeof saved !== 'object' || saved === null) return false;
  if (value instanceof PhysicsNode) return (saved as { nodeId?: number }).nodeId === value.id;
  if (Array.isArray(value))
    return (
      Array.isArray(saved) &&
      value.length === saved.length &&
      value.every((item, i) => alike(item, saved[i]))
    );
  const names = Object.keys(value);
  return (
    names.length === Object.keys(saved).length &&
    names.every((name) => alike(value[name as never], saved[name as never]))
  );
}
