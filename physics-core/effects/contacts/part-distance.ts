import { lengthOf } from '../../base/exact/index.js';
import { conjugate, rotate, subtract, type Pose } from '../../base/math.js';
import type { CollidablePart } from '../../dynamics/collidable.js';
import type { Vec3 } from '../../fields/types.js';
import { boxOf } from './part-box.js';

/** A point as it is seen from a pose. */
export const within = ({ p, q }: Pose, point: Vec3): Vec3 =>
  rotate(conjugate(q), subtract(point, p));

/** From the box around a part to a point in the body's frame, metres. */
export function distanceTo(part: CollidablePart, point: Vec3): number {
  const { min, max } = boxOf(part);
  const local = within(part.pose, point);
  return lengthOf(local.map((value, i) => Math.max(min[i]! - value, 0, value - max[i]!)));
}
