import { lengthOf } from './exact/index.js';
import { add, scale, subtract, type Pose, type Quaternion } from './math.js';

/** The pose `f` of the way from `a` to `b`: a straight line, and the normalised line between the quaternions. */
export function mix(a: Pose, b: Pose, f: number): Pose {
  const sign = a.q.reduce((sum, value, i) => sum + value * b.q[i]!, 0) < 0 ? -1 : 1;
  const q = a.q.map((value, i) => value + (sign * b.q[i]! - value) * f) as Quaternion;
  const size = lengthOf(q);
  return {
    p: add(a.p, scale(subtract(b.p, a.p), f)),
    q: q.map((value) => value / size) as Quaternion,
  };
}
