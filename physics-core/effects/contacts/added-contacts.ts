import type { Vec2, Vec3 } from '../../fields/types.js';
import {
  add,
  cross,
  dot,
  normalize,
  perpendicular,
  rotate,
  scale,
  subtract,
} from '../../base/math.js';
import type { BodyNode } from '../../nodes/body.js';
import type { ContactNode } from '../../nodes/contact.js';
import type { World } from '../../world/world.js';

/** Share of the depth that an added contact pushes out per step. */
const PUSH_SHARE = 0.2;

/** Rounds over all added contacts: as the solver's own at the finer levels. */
const ROUNDS = 20;

/** One direction of a contact: what it may push, and the speed that it pushes to. */
interface Row {
  direction: Vec3;
  /** Of both bodies, from their centres of mass. */
  arms: [Vec3, Vec3];
  response: number;
  target: number;
  impulse: number;
}

interface Moving {
  body: BodyNode;
  linear: Vec3;
  angular: Vec3;
}

/** A contact that page code made: one row that only pushes, two that rub. */
interface Added {
  bodies: (Moving | undefined)[];
  normal: Row;
  friction: { row: Row; limit: number }[];
}

/**
 * Contacts of page code where Bullet has none: solved before the step, impulse by impulse, from the velocities that
 * forces and gravity would lead to.
 */
export function solveAdded(contacts: readonly ContactNode[], world: World, dt: number): void {
  const moving = new Map<BodyNode, Moving>();
  const all = contacts.flatMap((contact) => addedContact(contact, moving, dt) ?? []);
  for (let i = 0; i < ROUNDS; i++) for (const one of all) solve(one);
  for (const { body, linear, angular } of moving.values()) {
    const { scratch } = world.engine;
    const before = predicted(body, dt);
    body.body.setLinearVelocity(scratch.vector(...kept(body, 0, linear, before.linear)));
    body.body.setAngularVelocity(scratch.vector(...kept(body, 3, angular, before.angular)));
    body.wake();
  }
}

/** The velocity that becomes `after` with what the step will add. */
function kept(body: BodyNode, at: number, after: Vec3, before: Vec3): Vec3 {
  const now = velocityNow(body);
  return [0, 1, 2].map((i) => now[at + i]! + after[i]! - before[i]!) as Vec3;
}

function addedContact(
  contact: ContactNode,
  moving: Map<BodyNode, Moving>,
  dt: number,
): Added | undefined {
  const bodies = contact.bodies.map((body) => body && movingOf(body, moving, dt));
  if (!bodies.some(Boolean)) return undefined;
  const { parameters } = contact;
  const normal = normalize(contact.asked<Vec3>('contactNormal'));
  const position = contact.asked<Vec3>('position');
  const depth = contact.asked<number>('depth');
  const approach = -speedOf(bodies, rowOf(bodies, position, normal, 0));
  const bounce = approach >= parameters.minBounceSpeed ? parameters.bounce * approach : 0;
  const push = depth > 0 ? (PUSH_SHARE * depth) / dt : depth / dt;
  const [first, second] = directionsOf(normal, parameters.direction);
  const rub = (direction: Vec3, which: 0 | 1): Added['friction'][0] => ({
    row: rowOf(bodies, position, direction, (parameters.speed as Vec2)[which]),
    limit: parameters.friction[which],
  });
  return {
    bodies,
    normal: rowOf(bodies, position, normal, Math.max(bounce, push)),
    friction: [rub(first, 0), rub(second, 1)],
  };
}

/** As for Bullet's contacts: what is given, or the world's x axis laid into the surface, and what is across. */
function directionsOf(normal: Vec3, given: Vec3 | undefined): [Vec3, Vec3] {
  const along = given ?? (Math.abs(normal[0]) > 0.9 ? [0, 0, 1] : [1, 0, 0]);
  const flat = subtract(along, scale(normal, dot(along, normal)));
  const first = normalize(flat, perpendicular(normal));
  return [first, cross(first, normal)];
}

function movingOf(body: BodyNode, moving: Map<BodyNode, Moving>, dt: number): Moving | undefined {
  if (!body.active || !body.movable) return undefined;
  let found = moving.get(body);
  if (!found) moving.set(body, (found = { body, ...predicted(body, dt) }));
  return found;
}

/** Velocities at the end of the step, without contacts. */
function predicted(body: BodyNode, dt: number): { linear: Vec3; angular: Vec3 } {
  const [vx, vy, vz, wx, wy, wz] = velocityNow(body);
  return { linear: add([vx!, vy!, vz!], scale(body.gravity, dt)), angular: [wx!, wy!, wz!] };
}

/** As Bullet has it: other effects changed it before this step. */
function velocityNow({ world, body, pointer }: BodyNode): Float64Array {
  const velocity = new Float64Array(6);
  world.engine.reader.velocity(body, pointer, velocity, 0);
  return velocity;
}

function rowOf(
  bodies: (Moving | undefined)[],
  position: Vec3,
  direction: Vec3,
  target: number,
): Row {
  const arms = bodies.map((one) =>
    one ? subtract(position, one.body.centerOfMassWorld()) : [0, 0, 0],
  ) as [Vec3, Vec3];
  let response = 0;
  bodies.forEach((one, i) => {
    if (!one) return;
    const turn = cross(arms[i]!, direction);
    response += 1 / one.body.mass.mass + dot(turn, turned(one.body, turn));
  });
  return { direction, arms, response, target, impulse: 0 };
}

/** What an angular impulse does to the spin of a body: world frame. */
function turned(body: BodyNode, impulse: Vec3): Vec3 {
  const { q } = body.pose();
  const principal = body.centerOfMass.q;
  const into = (v: Vec3): Vec3 => rotate(inverse(principal), rotate(inverse(q), v));
  const local = into(impulse).map((value, i) => value / body.mass.moments[i]!) as Vec3;
  return rotate(q, rotate(principal, local));
}

const inverse = (q: readonly number[]): [number, number, number, number] => [
  -q[0]!,
  -q[1]!,
  -q[2]!,
  q[3]!,
];

function speedOf(bodies: (Moving | undefined)[], { direction, arms }: Row): number {
  let speed = 0;
  bodies.forEach((one, i) => {
    if (!one) return;
    const v = add(one.linear, cross(one.angular, arms[i]!));
    speed += (i === 0 ? 1 : -1) * dot(v, direction);
  });
  return speed;
}

function solve({ bodies, normal, friction }: Added): void {
  push(bodies, normal, 0, Infinity);
  for (const { row, limit } of friction) {
    const most = limit * normal.impulse;
    push(bodies, row, -most, most);
  }
}

function push(bodies: (Moving | undefined)[], row: Row, least: number, most: number): void {
  const wanted = row.impulse + (row.target - speedOf(bodies, row)) / row.response;
  const impulse = Math.min(most, Math.max(least, wanted));
  const change = impulse - row.impulse;
  row.impulse = impulse;
  bodies.forEach((one, i) => {
    if (!one) return;
    const j = scale(row.direction, i === 0 ? change : -change);
    one.linear = add(one.linear, scale(j, 1 / one.body.mass.mass));
    one.angular = add(one.angular, turned(one.body, cross(row.arms[i]!, j)));
  });
}
