import {
  conjugate,
  cross,
  dot,
  rotate,
  scale,
  subtract,
  type Quaternion,
} from '../physics-core/base/math.js';
import type { Vec3 } from '../physics-core/fields/types.js';
import { follow } from './runge-kutta.js';

/** An ellipsoid that rolls on the plane y = 0 without slipping; its centre of mass is its middle. */
export interface RollingEllipsoid {
  /** Half axes along x, y, z, metres. */
  half: Vec3;
  mass: number;
  /** About the centre of mass, row by row, kg m². */
  inertia: readonly number[];
  /** m/s² */
  gravity: number;
  orientation: Quaternion;
  /** rad/s, in the world. */
  spin: Vec3;
}

/**
 * Its spin as seen from the world, its height, its energy, 1/60 s apart. The floor's push F at the arm r is what moves the
 * centre: m v̇ = F - m g n; where nothing slips v = -ω × r. So the only unknown left is ω̇, in the body's frame:
 * I ω̇ + m r × (ω̇ × r) = -ω × I ω + m r × (g n - ω × ṙ).
 */
export function rollingEllipsoid(asked: RollingEllipsoid, perFrame = 400) {
  const { orientation, spin } = asked;
  const start = [...orientation, ...rotate(conjugate(orientation), spin)];
  const states = follow(start, (state) => rates(asked, state), perFrame);
  return {
    velocity: rollingVelocity(asked, orientation, spin),
    height: heightOf(asked, orientation),
    at: (frame: number) => {
      const [q, w] = parts(states(frame));
      return { spin: rotate(q, w), energy: energyOf(asked, q, w) };
    },
  };
}

function parts(state: readonly number[]): [Quaternion, Vec3] {
  const q = state.slice(0, 4);
  const size = Math.hypot(...q);
  return [q.map((value) => value / size) as Quaternion, state.slice(4) as Vec3];
}

const upIn = (q: Quaternion): Vec3 => rotate(conjugate(q), [0, 1, 0]);

const squared = ({ half }: RollingEllipsoid, n: Vec3): Vec3 =>
  n.map((x, i) => half[i]! ** 2 * x) as Vec3;

/** From the middle to where it touches a plane that lies along -n. */
function arm(asked: RollingEllipsoid, n: Vec3): Vec3 {
  const far = squared(asked, n);
  return scale(far, -1 / Math.sqrt(dot(n, far)));
}

const heightOf = (asked: RollingEllipsoid, q: Quaternion): number => {
  const n = upIn(q);
  return -dot(arm(asked, n), n);
};

function rollingVelocity(asked: RollingEllipsoid, q: Quaternion, spin: Vec3): Vec3 {
  return cross(rotate(q, arm(asked, upIn(q))), spin);
}

const times = (m: readonly number[], [x, y, z]: Vec3): Vec3 =>
  [0, 3, 6].map((i) => m[i]! * x + m[i + 1]! * y + m[i + 2]! * z) as Vec3;

function rates(asked: RollingEllipsoid, state: readonly number[]): number[] {
  const { mass, inertia, gravity } = asked;
  const [q, w] = parts(state);
  const n = upIn(q);
  const r = arm(asked, n);
  // How n, and with it the arm, change as the body sees them; then as one sees them who stands still.
  const turned = cross(n, w);
  const far = squared(asked, n);
  const square = dot(n, far);
  const wander = scale(
    subtract(squared(asked, turned), scale(far, dot(turned, far) / square)),
    -1 / Math.sqrt(square),
  );
  const goes = wander.map((x, i) => x + cross(w, r)[i]!) as Vec3;
  const pull = subtract(scale(n, gravity), cross(w, goes));
  const torque = subtract(scale(cross(r, pull), mass), cross(w, times(inertia, w)));
  const whole = inertia.map((x, k) => {
    const [i, j] = [Math.floor(k / 3), k % 3];
    return x + mass * ((i === j ? dot(r, r) : 0) - r[i]! * r[j]!);
  });
  return [...turning(q, w), ...solved(whole, torque)];
}

/** q̇ = q ω / 2, ω in the body's frame. */
const turning = ([x, y, z, s]: Quaternion, [a, b, c]: Vec3): number[] =>
  [s * a + y * c - z * b, s * b + z * a - x * c, s * c + x * b - y * a, -x * a - y * b - z * c].map(
    (value) => value / 2,
  );

/** m x = b, by Cramer's rule; `m` is symmetric. */
function solved(m: readonly number[], b: Vec3): Vec3 {
  const [one, two, three] = [0, 3, 6].map((i) => m.slice(i, i + 3) as Vec3) as [Vec3, Vec3, Vec3];
  const whole = dot(one, cross(two, three));
  return [
    dot(b, cross(two, three)) / whole,
    dot(one, cross(b, three)) / whole,
    dot(one, cross(two, b)) / whole,
  ];
}

function energyOf(asked: RollingEllipsoid, q: Quaternion, w: Vec3): number {
  const { mass, inertia, gravity } = asked;
  const v = cross(w, arm(asked, upIn(q)));
  return (mass * dot(v, v) + dot(w, times(inertia, w))) / 2 + mass * gravity * heightOf(asked, q);
}
