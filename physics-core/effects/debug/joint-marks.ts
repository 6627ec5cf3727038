import { cos, sin } from '../../base/exact/index.js';
import { JointView } from '../../engine/joint-view.js';
import type { Vec3 } from '../../fields/types.js';
import { add, AXES, compose, cross, normalize, rotate, scale, type Pose } from '../../base/math.js';
import type { Body } from '../../dynamics/body.js';
import type { Joint } from '../../dynamics/joint.js';
import type { Simulation } from '../../dynamics/simulation.js';
import { COLOR } from './colors.js';
import type { DebugLines } from './debug-lines.js';

/** Size of what is drawn of a joint, in marks of its smaller body. */
const SIZE = 3;
/** Turn of one piece of an arc, radians. */
const PIECE = Math.PI / 16;

/** A joint as Bullet's constraint has it. A and B are Bullet's; rows lie along A's frame. */
interface Seen {
  lines: DebugLines;
  size: number;
  a: Pose;
  b: Pose;
  /** Bounds of a row; a lower above an upper one: free. */
  bounds(row: number): readonly [number, number];
}

/** Where a joint holds each body, its axes, and how far it may go. */
export function markJoint(lines: DebugLines, { engine }: Simulation, joint: Joint): void {
  const { constraint, body1, body2 } = joint;
  if (!constraint) return;
  const view = new JointView(engine.ammo);
  const [bodyA, bodyB] = constraint.swapped ? [body2, body1] : [body1, body2];
  const frame = (body: Body | undefined, side: 'A' | 'B'): Pose =>
    compose(lines.poseOf(body), view.frame(constraint.pointer, side));
  const seen: Seen = {
    lines,
    size: sizeOf(lines, [body1, body2]),
    a: frame(bodyA, 'A'),
    b: frame(bodyB, 'B'),
    bounds: (row) =>
      lockedBounds(joint, row) ?? softBounds(joint, row) ?? view.bounds(constraint.pointer, row),
  };
  hold(seen, bodyA, seen.a);
  hold(seen, bodyB, seen.b);
  for (const row of [0, 1, 2]) slide(seen, row);
  if ([3, 4, 5].some((row) => locked(seen.bounds(row)))) turn(seen);
}

function sizeOf(lines: DebugLines, bodies: readonly (Body | undefined)[]): number {
  const movable = bodies.filter((body) => body?.movable) as Body[];
  return SIZE * Math.min(...movable.map((body) => lines.markOn(body)));
}

/** Bullet's rows that lock are let go as long as nothing touches their bodies. */
const lockedBounds = (joint: Joint, row: number): readonly [number, number] | undefined =>
  joint.lockedRows.includes(row) ? [0, 0] : undefined;

/** Stops that give way are kept by an effect; Bullet's row is free there. They are of body1 against body2, A and B. */
function softBounds({ stops }: Joint, row: number): readonly [number, number] | undefined {
  const soft = stops.find((stop) => stop.row === row && stop.softness > 0);
  return soft && [soft.low, soft.high];
}

const locked = ([low, high]: readonly [number, number]): boolean => low === high;

/** From the centre of mass to the joint, and a cross there. */
function hold({ lines, size }: Seen, body: Body | undefined, frame: Pose): void {
  if (body) lines.line(lines.poseOf(body).p, frame.p, COLOR.joint);
  const axes = AXES.map((axis) => scale(rotate(frame.q, axis), size / 4));
  lines.cross(frame.p, axes, COLOR.joint);
}

/** The way that a row leaves B along an axis of A's frame. */
function slide({ lines, size, a, bounds }: Seen, row: number): void {
  const [low, high] = bounds(row);
  if (low === high || freeEverywhere(bounds)) return;
  const limited = low < high;
  const along = rotate(a.q, AXES[row]!);
  const across = scale(rotate(a.q, AXES[(row + 1) % 3]!), size / 4);
  const end = (at: number): Vec3 => add(a.p, scale(along, at));
  const reach = (at: number, free: number): number => (limited && Number.isFinite(at) ? at : free);
  const from = reach(low, -size);
  const to = reach(high, size);
  lines.line(end(from), end(to), limited ? COLOR.limit : COLOR.joint);
  if (!limited) return;
  for (const at of [low, high])
    if (Number.isFinite(at)) lines.cross(end(at), [across], COLOR.limit);
}

/** A motor holds nothing. */
const freeEverywhere = (bounds: Seen['bounds']): boolean =>
  [0, 1, 2, 3, 4, 5].every((row) => bounds(row)[0] > bounds(row)[1]);

/**
 * Axes about which the joint turns: x of B, and z of A. What is at right angles to both stands still when either body
 * turns about its own, and so tells the angle of each. About x it is seen from z, which a hinge has along its arm.
 */
function turn(seen: Seen): void {
  const { a, b, bounds } = seen;
  const x = rotate(b.q, [1, 0, 0]);
  const z = rotate(a.q, [0, 0, 1]);
  const across = normalize(cross(z, x));
  const fromB = (angle: number): Vec3 => rotate(b.q, [0, -sin(angle), cos(angle)]);
  const fromA = (angle: number): Vec3 => rotate(a.q, [sin(angle), cos(angle), 0]);
  if (!locked(bounds(3))) fan(seen, b.p, x, cross(x, across), bounds(3), fromB);
  if (!locked(bounds(5))) fan(seen, a.p, z, across, bounds(5), fromA);
}

/** An axis; where it has stops an arc between them, and where the joint stands. */
function fan(
  { lines, size }: Seen,
  at: Vec3,
  axis: Vec3,
  pointer: Vec3,
  [low, high]: readonly [number, number],
  direction: (angle: number) => Vec3,
): void {
  lines.cross(at, [scale(axis, size)], COLOR.joint);
  if (low > high) return;
  const rim = (angle: number): Vec3 => add(at, scale(direction(angle), size));
  lines.line(at, rim(low), COLOR.limit);
  lines.line(at, rim(high), COLOR.limit);
  lines.line(at, add(at, scale(pointer, size)), COLOR.joint);
  const pieces = Math.ceil((high - low) / PIECE);
  for (let i = 0; i < pieces; i++) {
    const angle = (k: number): number => low + ((high - low) * k) / pieces;
    lines.line(rim(angle(i)), rim(angle(i + 1)), COLOR.limit);
  }
}
