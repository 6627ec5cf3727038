import type { Vec3 } from '../physics-core/fields/types.js';
import { conjugate, cross, multiply, rotate, type Quaternion } from '../physics-core/base/math.js';
import { follow } from './runge-kutta.js';

/** A body that turns about a point that stands: its centre of mass, or a ball joint. */
export interface Turning {
  /** Principal moments about that point, kg m², along the body's axes. */
  moments: Vec3;
  orientation?: Quaternion;
  /** rad/s, world frame. */
  spin: Vec3;
  /** From the point to where the weight acts, in the body's frame, metres; and the weight, newtons. */
  arm?: Vec3;
  weight?: Vec3;
}

const over = (a: Vec3, b: Vec3): Vec3 => [a[0] / b[0], a[1] / b[1], a[2] / b[2]];
const times = (a: Vec3, b: Vec3): Vec3 => [a[0] * b[0], a[1] * b[1], a[2] * b[2]];

/** Its orientation each 1/60 s: Euler's equations in double precision, with the angular momentum in the world's frame. */
export function turn(
  { moments, orientation = [0, 0, 0, 1], spin, arm = [0, 0, 0], weight = [0, 0, 0] }: Turning,
  perFrame = 64,
): (frame: number) => Quaternion {
  const momentum = rotate(orientation, times(moments, rotate(conjugate(orientation), spin)));
  const states = follow(
    [...orientation, ...momentum],
    ([x, y, z, w, ...l]) => {
      const q: Quaternion = [x!, y!, z!, w!];
      const rate = rotate(q, over(rotate(conjugate(q), l as Vec3), moments));
      return [
        ...multiply([...rate, 0], q).map((value) => value / 2),
        ...cross(rotate(q, arm), weight),
      ];
    },
    perFrame,
  );
  return (frame) => {
    const state = states(frame);
    const size = Math.hypot(...state.slice(0, 4));
    return state.slice(0, 4).map((value) => value / size) as Quaternion;
  };
}
