import type { Vec2, Vec3 } from '../../fields/types.js';
import { add, cross, dot, normalize, scale, subtract } from '../../base/math.js';
import type { Body, Velocity } from '../../dynamics/body.js';
import { applyInverseInertia } from '../../dynamics/inertia.js';
import type { Contact } from '../../dynamics/contact.js';
import type { Simulation } from '../../dynamics/simulation.js';
import { layInSurface } from './friction-directions.js';

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
  body: Body;
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
export function solveAdded(contacts: readonly Contact[], simulation: Simulation, dt: number): void {
  const moving = new Map<Body, Moving>();
  const movingOf = (body: Body | undefined): Moving | undefined => {
    if (!body?.active || !body.movable) return undefined;
    let found = moving.get(body);
    if (!found) moving.set(body, (found = { body, ...predicted(simulation, body, dt) }));
    return found;
  };
  const all = contacts.flatMap((contact) => addedContact(contact, movingOf, dt) ?? []);
  for (let i = 0; i < ROUNDS; i++) for (const one of all) solve(one);
  for (const one of moving.values()) give(simulation, one, dt);
}

/** The velocity that becomes the one found with what the step will add. */
function give(simulation: Simulation, { body, linear, angular }: Moving, dt: number): void {
  const { scratch } = simulation.engine;
  const before = predicted(simulation, body, dt);
  const now = velocityNow(simulation, body);
  const kept = (found: Vec3, was: Vec3, nows: Vec3): Vec3 =>
    found.map((value, i) => nows[i]! + value - was[i]!) as Vec3;
  body.body.setLinearVelocity(scratch.vector(...kept(linear, before.linear, now.linear)));
  body.body.setAngularVelocity(scratch.vector(...kept(angular, before.angular, now.angular)));
  body.wake();
}

function addedContact(
  { bodies: named, parameters, touching }: Contact,
  movingOf: (body: Body | undefined) => Moving | undefined,
  dt: number,
): Added | undefined {
  const bodies = named.map(movingOf);
  if (!bodies.some(Boolean)) return undefined;
  const { position, depth } = touching;
  const normal = normalize(touching.normal);
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

/** As for Bullet's contacts. */
function directionsOf(normal: Vec3, given: Vec3 | undefined): [Vec3, Vec3] {
  layInSurface(laid, ...normal, given);
  const first: Vec3 = [laid[0]!, laid[1]!, laid[2]!];
  return [first, cross(first, normal)];
}

const laid = new Float64Array(3);

/** Velocities at the end of the step, without contacts. */
function predicted(simulation: Simulation, body: Body, dt: number): Velocity {
  const { linear, angular } = velocityNow(simulation, body);
  return { linear: add(linear, scale(body.gravity, dt)), angular };
}

/** As Bullet has it: other effects changed it before this step. */
function velocityNow({ engine }: Simulation, { pointer }: Body): Velocity {
  const v = new Float64Array(6);
  engine.reader.velocity(pointer, v, 0);
  return { linear: [v[0]!, v[1]!, v[2]!], angular: [v[3]!, v[4]!, v[5]!] };
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
    response += 1 / one.body.mass.mass + dot(turn, applyInverseInertia(one.body, turn));
  });
  return { direction, arms, response, target, impulse: 0 };
}

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
    one.angular = add(one.angular, applyInverseInertia(one.body, cross(row.arms[i]!, j)));
  });
}
