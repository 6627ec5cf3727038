import { allEffects } from '../../physics-core/effects/all.js';
import type { Field, PhysicsNode, World } from '../../physics-core/inside.js';
import { BODY } from '../../physics-core/engine/offsets.js';
import type { JointConstraint } from '../../physics-core/engine/joint-constraint.js';
import { BodyNode } from '../../physics-core/nodes/body/body.js';
import { CollisionCollectionNode } from '../../physics-core/nodes/collision/collision-collection-node.js';
import { JointNode } from '../../physics-core/nodes/joints/joint.js';
import { quaternionOf } from '../../physics-core/base/math.js';
import { plain } from '../conformance/plain.js';

/**
 * All there is to know of a world, item by item: `name.field` as it is read, `name~what` of its Bullet
 * object, `@what` of Bullet's world. What an
 * edit did is the items that differ.
 */
export type State = Map<string, string>;

/** What poses and velocities may be off by when they go to single precision and back. */
const ROUNDING = 1e-5;

/** Numbers rounded, elements by their names. */
function shown(item: unknown): unknown {
  if (typeof item === 'number' && Number.isFinite(item))
    return Math.round(item / ROUNDING) * ROUNDING;
  return globalThis.Element && item instanceof Element ? item.getAttribute('DEF') : item;
}

const text = (value: unknown): string =>
  JSON.stringify(value, (_, item) => shown(item)) ?? 'nothing';

/** The value of a field as an item. Of a turn by nearly nothing the axis is noise. */
export const itemOf = ({ type }: Field, value: unknown): string =>
  text(type === 'SFRotation' ? quaternionOf(value as number[]) : plain(value));

const numbers = new WeakMap<object, number>();
let known = 0;

/** Which object it is: another one has another number. */
const identity = (object: object | undefined): number => {
  if (!object) return 0;
  if (!numbers.has(object)) numbers.set(object, ++known);
  return numbers.get(object)!;
};

export function stateOf(world: World): State {
  world.step(0);
  const state: State = new Map();
  for (const node of [world.settings, ...world.nodes]) {
    const { name } = node;
    if (!name) continue;
    for (const [spelled, field] of Object.entries(node.type.fields))
      if (field.access !== 'inputOnly')
        state.set(`${name}.${spelled}`, itemOf(field, node.get(spelled)));
    for (const [what, value] of Object.entries(innards(node)))
      state.set(`${name}~${what}`, text(value));
  }
  for (const [what, value] of Object.entries(ofWorld(world))) state.set(`@${what}`, text(value));
  return state;
}

function innards(node: PhysicsNode): Record<string, unknown> {
  const effects = allEffects.filter((each) => node.world.registry.find(each)?.isNeededBy(node));
  const common = { built: node.built, effects: effects.map(({ name }) => name) };
  if (node instanceof BodyNode) return { ...common, ...ofBody(node) };
  if (node instanceof JointNode) return { ...common, ...ofJoint(node) };
  if (node instanceof CollisionCollectionNode) return { ...common, parameters: node.parameters };
  return common;
}

function ofBody(node: BodyNode): Record<string, unknown> {
  const { body, pointer, world } = node;
  const { ammo } = world.engine;
  const float = (offset: number): number => ammo.HEAPF32[(pointer + offset) >> 2]!;
  const gravity = body.getGravity();
  const proxy = node.active ? body.getBroadphaseHandle() : undefined;
  return {
    object: pointer,
    shape: ammo.getPointer(body.getCollisionShape()),
    parts: node.solidParts.map(({ geometry, pose }) => ({ geometry, pose })),
    mass: [0, 4, 8].map((i) => float(BODY.inverseInertiaLocal + i)).concat(float(BODY.inverseMass)),
    centre: node.centerOfMass,
    gravity: [gravity.x(), gravity.y(), gravity.z()],
    damping: [body.getLinearDamping(), body.getAngularDamping()],
    flags: [body.getCollisionFlags(), body.getFlags()],
    rest: node.rest,
    awake: node.active && !node.sleeping,
    active: node.active,
    groups: proxy && [proxy.get_m_collisionFilterGroup(), proxy.get_m_collisionFilterMask()],
  };
}

interface Driven {
  stops?: readonly object[];
  motors?: unknown;
  spring?: unknown;
}

function ofJoint(node: JointNode): Record<string, unknown> {
  const { stops, motors, spring } = node as Driven;
  return {
    object: identity(node.constraint satisfies JointConstraint | undefined),
    bodies: [node.body1?.name, node.body2?.name],
    frames: [node.centred1, node.centred2],
    limits: node.limits,
    corrections: node.corrections,
    stops,
    motors,
    spring,
  };
}

function ofWorld(world: World): Record<string, unknown> {
  const touching: string[] = [];
  world.bullet.eachTouchingPair((_first, _count, a, b) => {
    touching.push(
      [a, b]
        .map((pointer) => world.bodyAt(pointer)?.name)
        .sort()
        .join(),
    );
  });
  return {
    solver: [world.bullet.settings, world.solver, world.timeStep],
    enabled: world.control.enabled,
    touching: touching.sort(),
    meeting: meetings(world),
    time: world.time,
  };
}

/** The pairs of collidables of which Bullet looks for contacts. */
function meetings(world: World): string[] {
  const found: string[] = [];
  const sides = [...world.bodies].flatMap((side) =>
    side.parts.map(({ collidable }) => ({ side, collidable })),
  );
  for (const a of sides)
    for (const b of sides)
      if (a.side.id < b.side.id && world.pairs.meet(a.side, a.collidable, b.side, b.collidable))
        found.push(`${a.collidable.name} ${b.collidable.name}`);
  return found;
}

/** The items that differ, in order. */
export function differences(before: State, after: State): string[] {
  const items = new Set([...before.keys(), ...after.keys()]);
  return [...items].filter((item) => before.get(item) !== after.get(item)).sort();
}
