import { conjugate, length, multiply, subtract } from '../../physics-core/base/math.js';
import type { Quaternion, Vec3, Watch } from '../case.js';

/** Looks in 1/60 s. */
export const frameOf = (time: number): number => Math.round(60 * time);

/** The worst of what each look finds wrong. */
export function worst(wrong: (time: number) => number): Watch {
  let most = 0;
  return {
    // Not Math.max alone: what is not finite stays so.
    look: (time) => (most = Math.max(most, wrong(time))),
    error: () => most,
  };
}

/** The inertia of what turns alike about all axes. */
export const round = (moment: number): Vec3 => [moment, moment, moment];

/** Metres between two places. */
export const apart = (a: Vec3, b: Vec3): number => length(subtract(a, b));

/** Radians between two orientations. */
export function turned(a: Quaternion, b: Quaternion): number {
  const [x, y, z, w] = multiply(conjugate(a), b);
  return 2 * Math.atan2(Math.hypot(x, y, z), Math.abs(w));
}

/** Steps per second of the finest level. */
const STEPS = 960;

/**
 * What single precision alone leaves after so many seconds: each step at the finest level rounds the place and the speed,
 * to 2^-23 of the largest they come to, spread evenly; such errors add up as a random walk does.
 */
export function rounding(place: number, speed: number, seconds: number): number {
  const each = 2 ** -23 / Math.sqrt(12);
  return each * Math.sqrt(STEPS * seconds) * (place + (speed * seconds) / Math.sqrt(3));
}
