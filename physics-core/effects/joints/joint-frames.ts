import type { Vec3 } from '../../fields/types.js';
import {
  cross,
  dot,
  length,
  normalize,
  perpendicular,
  quaternionOfAxes,
  scale,
  subtract,
  type Quaternion,
} from '../../base/math.js';
import type { Body } from '../../dynamics/body.js';

/** Where a joint sits, world frame, at the moment it is made. */
export interface JointFrame {
  anchor: Vec3;
  /** The frame's x, for joints about or along one axis. */
  axis?: Vec3;
  /** z of body1's frame and x of body2's, for joints about two axes; they need not be at right angles. */
  axes?: readonly [Vec3, Vec3];
}

/** The frame's axes as body1 and as body2 carry them. */
export type Orientations = [Quaternion, Quaternion];

/**
 * Rows along the lever arm: world axes would couple the rows through a small inertia, and the solver would let the
 * joint open (measured). Without an axis of its own the frame's x runs along the arm; else its z does.
 */
function alongArm(arm: Vec3, axis: Vec3 | undefined): Orientations {
  if (!axis) {
    const x = normalize(arm, [1, 0, 0]);
    const y = perpendicular(x);
    const q = quaternionOfAxes(x, y, cross(x, y));
    return [q, q];
  }
  const x = normalize(axis);
  const across = subtract(arm, scale(x, dot(arm, x)));
  const z = length(across) > 1e-6 ? normalize(across) : perpendicular(x);
  const q = quaternionOfAxes(x, cross(z, x), z);
  return [q, q];
}

/** Both frames share their y, which is at right angles to both axes: the 6-DoF's middle angle, where it is singular. */
function aboutTwoAxes([z1, x2]: readonly [Vec3, Vec3]): Orientations {
  const y = normalize(cross(z1, x2));
  return [quaternionOfAxes(cross(y, z1), y, z1), quaternionOfAxes(x2, y, cross(x2, y))];
}

/** The frame's axes of a joint whose longest lever arm is this. */
export const orientations = ({ axis, axes }: JointFrame, arm: Vec3): Orientations =>
  axes ? aboutTwoAxes(axes) : alongArm(arm, axis);

/** m r² / I: how badly a point at the end of the lever arm couples to the body's rotation. */
export function leverRatio(body: Body | undefined, anchor: Vec3): number {
  if (!body?.movable) return -1;
  const arm = length(subtract(body.centerOfMassWorld(), anchor));
  return (body.mass.mass * arm * arm) / Math.min(...body.mass.moments);
}
