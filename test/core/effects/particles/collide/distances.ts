import type { Vec3 } from '../../../helpers.js';

// Independent of what is tested: how far things are from a point, below 0 inside, and where a ball on a straight way touches
// them first, by that distance alone.

/** Metres. */
export type Distance = (at: Vec3) => number;

export const plus = (a: Vec3, b: Vec3, s = 1): Vec3 => [
  a[0] + b[0] * s,
  a[1] + b[1] * s,
  a[2] + b[2] * s,
];
export const inner = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const size = (a: Vec3): number => Math.hypot(...a);
export const across = (a: Vec3, b: Vec3): Vec3 => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

export const fromBall =
  (radius: number): Distance =>
  (at) =>
    size(at) - radius;

export const fromBox =
  (half: Vec3): Distance =>
  (at) => {
    const over = at.map((value, i) => Math.abs(value) - half[i]!);
    const out = Math.hypot(...over.map((value) => Math.max(0, value)));
    return out > 0 ? out : Math.max(...over);
  };

/** By the outline that goes round the axis: three straight lines. */
export const fromFrustum =
  (bottom: number, top: number, half: number): Distance =>
  ([x, y, z]) => {
    const r = Math.hypot(x, z);
    const corners = [
      [0, -half],
      [bottom, -half],
      [top, half],
      [0, half],
    ] as const;
    let least = Infinity;
    for (let i = 0; i < 3; i++) {
      const [[a, b], [c, d]] = [corners[i]!, corners[i + 1]!];
      const length = (c - a) ** 2 + (d - b) ** 2;
      const share = length > 0 ? ((r - a) * (c - a) + (y - b) * (d - b)) / length : 0;
      const s = Math.min(1, Math.max(0, share));
      least = Math.min(least, Math.hypot(r - a - (c - a) * s, y - b - (d - b) * s));
    }
    const radius = bottom + ((top - bottom) * (y + half)) / (2 * half);
    return Math.abs(y) <= half && r <= radius ? -least : least;
  };

/** By halving the place of the nearest point on its normal. */
export const fromEgg =
  (half: Vec3): Distance =>
  (at) => {
    const value = (far: number): number =>
      at.reduce((sum, x, i) => sum + ((half[i]! * x) / (half[i]! ** 2 + far)) ** 2, -1);
    let [low, high] = [-(Math.min(...half) ** 2) + 1e-12, 10];
    for (let i = 0; i < 70; i++) {
      const middle = (low + high) / 2;
      if (value(middle) > 0) low = middle;
      else high = middle;
    }
    const off = Math.hypot(...at.map((x, i) => x - (half[i]! ** 2 * x) / (half[i]! ** 2 + low)));
    return value(0) > 0 ? off : -off;
  };

/** The nearest point of a triangle, by the regions around it (Ericson, Real-Time Collision Detection, 5.1.5). */
export function fromTriangle(a: Vec3, b: Vec3, c: Vec3): Distance {
  return (p) => {
    const [ab, ac, ap] = [plus(b, a, -1), plus(c, a, -1), plus(p, a, -1)];
    const [d1, d2] = [inner(ab, ap), inner(ac, ap)];
    const to = (q: Vec3): number => size(plus(p, q, -1));
    if (d1 <= 0 && d2 <= 0) return to(a);
    const bp = plus(p, b, -1);
    const [d3, d4] = [inner(ab, bp), inner(ac, bp)];
    if (d3 >= 0 && d4 <= d3) return to(b);
    const vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return to(plus(a, ab, d1 / (d1 - d3)));
    const cp = plus(p, c, -1);
    const [d5, d6] = [inner(ab, cp), inner(ac, cp)];
    if (d6 >= 0 && d5 <= d6) return to(c);
    const vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return to(plus(a, ac, d2 / (d2 - d6)));
    const va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
      return to(plus(b, plus(c, b, -1), (d4 - d3) / (d4 - d3 + d5 - d6)));
    const under = 1 / (va + vb + vc);
    return to(plus(plus(a, ab, vb * under), ac, vc * under));
  };
}

type Triangle = readonly [number, number, number];

export const trianglesOf = (points: readonly number[], index: readonly Triangle[]): Distance[] => {
  const at = (i: number): Vec3 => [points[3 * i]!, points[3 * i + 1]!, points[3 * i + 2]!];
  return index.map(([a, b, c]) => fromTriangle(at(a), at(b), at(c)));
};

/** Of a hull, by its triangles against the clock. */
export function fromHull(points: readonly number[], index: readonly Triangle[]): Distance {
  const all = trianglesOf(points, index);
  const at = (i: number): Vec3 => [points[3 * i]!, points[3 * i + 1]!, points[3 * i + 2]!];
  const planes = index.map(([a, b, c]) => {
    const normal = across(plus(at(b), at(a), -1), plus(at(c), at(a), -1));
    return { normal, height: inner(normal, at(a)) };
  });
  return (p) => {
    const least = Math.min(...all.map((distance) => distance(p)));
    return planes.every(({ normal, height }) => inner(normal, p) <= height) ? -least : least;
  };
}

/** Where the distance from something convex is a radius first, or NaN; `least`: the least that there is on the way. */
export function firstTouch(distance: Distance, from: Vec3, to: Vec3, radius: number) {
  const way = plus(to, from, -1);
  const gap = (share: number): number => distance(plus(from, way, share)) - radius;
  if (gap(0) <= 0) return { share: 0, least: gap(0) };
  let [low, high] = [0, 1];
  for (let i = 0; i < 60; i++) {
    const [a, b] = [low + (high - low) / 3, high - (high - low) / 3];
    if (gap(a) <= gap(b)) high = b;
    else low = a;
  }
  const bottom = [low, high, 1].reduce((best, at) => (gap(at) < gap(best) ? at : best));
  const least = gap(bottom);
  if (least > 0) return { share: NaN, least };
  [low, high] = [0, bottom];
  for (let i = 0; i < 45; i++) {
    const middle = (low + high) / 2;
    if (gap(middle) > 0) low = middle;
    else high = middle;
  }
  return { share: high, least };
}

/** The direction in which a distance grows. */
export function gradient(distance: Distance, at: Vec3, step = 1e-6): Vec3 {
  const slope = [0, 1, 2].map((i) => {
    const [a, b] = [[...at] as Vec3, [...at] as Vec3];
    a[i]! -= step;
    b[i]! += step;
    return (distance(b) - distance(a)) / (2 * step);
  }) as Vec3;
  return slope.map((value) => value / size(slope)) as Vec3;
}
