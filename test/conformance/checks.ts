import type { Check } from './fact.js';

/** A frame of 60 in a second, seconds. */
export const FRAME = 1 / 60;

/**
 * What browsers may differ by in time, seconds: a frame until an event acts, and another that what is shown may lag
 * behind. Tolerances are this times the speed (of a speed: times the acceleration).
 */
export const LAG = 2 * FRAME;

/** Share by which a way may be off where the question is whether and when something moves, not how far. */
export const ROUGH = 0.15;

export const near = (
  what: string,
  actual: number | number[],
  expected: number | number[],
  tolerance: number,
  unit: string,
): Check => ({ what, actual, expected, tolerance, unit });

/** Exactly equal: words, names, nothing. */
export const same = (
  what: string,
  actual: Check['actual'],
  expected: Check['expected'],
): Check => ({ what, actual, expected });

/** An inequality, said in words. */
export const holds = (what: string, actual: boolean): Check => ({ what, actual, expected: true });

export const distance = (a: readonly number[], b: readonly number[]): number =>
  Math.hypot(...a.map((value, i) => value - b[i]!));

/** A rotation as axis × angle, angle within (-π, π]: one triple for all the ways to write it. */
export function turn([x, y, z, angle]: number[]): number[] {
  const axis = Math.hypot(x!, y!, z!) || 1;
  const shortest = Math.atan2(Math.sin(angle!), Math.cos(angle!));
  return [x!, y!, z!].map((value) => (value / axis) * shortest);
}

/** A vector turned about Z, radians. */
export const aboutZ = ([x, y, z]: number[], angle: number): number[] => [
  x! * Math.cos(angle) - y! * Math.sin(angle),
  x! * Math.sin(angle) + y! * Math.cos(angle),
  z!,
];

/** A vector turned by an X3D rotation. */
export function rotated(v: number[], [x, y, z, angle]: number[]): number[] {
  const length = Math.hypot(x!, y!, z!) || 1;
  const k = [x! / length, y! / length, z! / length];
  const [sin, cos] = [Math.sin(angle!), Math.cos(angle!)];
  const along = (k[0]! * v[0]! + k[1]! * v[1]! + k[2]! * v[2]!) * (1 - cos);
  const across = [0, 1, 2].map((i) => {
    const [a, b] = [(i + 1) % 3, (i + 2) % 3];
    return k[a]! * v[b]! - k[b]! * v[a]!;
  });
  return v.map((value, i) => value * cos + across[i]! * sin + k[i]! * along);
}
