import type { World } from '../../../../physics-core/inside.js';
import type { Body, Node } from '../../helpers.js';

/** m/s² of the worlds of these facts. */
export const G = 9.8;

/** Water without any resistance. */
export const IDEAL = { dragCoefficient: 0, liftCoefficient: 0, damping: 0 };

/** So much of it that what floats lies still after some seconds. */
export const THICK = { damping: 6 };

/** A sea whose surface is at y = 0. */
export const addSea = (to: World, fields: Record<string, unknown> = {}): Node =>
  to.add('WaterVolume', { size: [400, 400, 400], position: [0, -200, 0], ...fields });

/** Of something that swings about 0: the mean period, seconds, and the greatest value in the last quarter of the time. */
export function swing(
  w: World,
  seconds: number,
  show: () => number,
): { period: number; most: number } {
  const dt = w.timeStep;
  const crossings: number[] = [];
  let last = 0;
  let before = show();
  let most = 0;
  for (let i = 0; i < seconds / dt; i++) {
    w.step();
    const now = show();
    if (before < 0 !== now < 0) crossings.push(w.time - (now / (now - before)) * dt);
    if (i > (0.75 * seconds) / dt) most = Math.max(most, Math.abs(crest(last, before, now)));
    last = before;
    before = now;
  }
  return { period: (2 * (crossings.at(-1)! - crossings[0]!)) / (crossings.length - 1), most };
}

/** Of a parabola through three values, where the middle one is the greatest or the least; 0 where it is not. */
function crest(a: number, b: number, c: number): number {
  return (b - a) * (b - c) > 0 ? b - (a - c) ** 2 / (8 * (a - 2 * b + c)) : 0;
}

/** Radians about z. */
export function tilt(body: Body): number {
  const [, , z, angle] = body.get('orientation') as number[];
  return angle! * z!;
}
