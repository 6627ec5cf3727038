import type { Body } from './body.js';
import type { Joint } from './joint.js';

/**
 * Whether the joint solve keeps a joint: it stands in the world and some row of it holds. One whose body is disabled, or is
 * not there yet, keeps nothing, nor does one with free rows only, as MotorJoint is.
 */
export const holds = ({ attached, lockedRows }: Joint): boolean =>
  attached && lockedRows.length > 0;

/** Whether anything may hold it: a joint, or a rope. */
export const isHeld = ({ joints, ties }: Body): boolean => joints.size > 0 || ties.size > 0;

/** Whether the joint solve moves a body: some joint holds it to another one, or to the world, or a rope does. */
export function isJointed(body: Body): boolean {
  if (body.ties.size > 0) return body.movable;
  for (const joint of body.joints) if (holds(joint)) return body.movable;
  return false;
}
