import { cos, sin } from '../base/exact/index.js';
import type { Mesh } from './geometry.js';

/** Sides of a ring: the radius of the polygon is then within 0.5 % of the circle's. */
export const SIDES = 32;

/** A surface of revolution about Y: `profile` from bottom to top as [radius, y]. */
export function turned(profile: [number, number][]): Mesh {
  const points: number[] = [];
  const index: number[] = [];
  profile.forEach(([radius, y], ring) => {
    for (let i = 0; i < SIDES; i++) {
      const angle = (2 * Math.PI * i) / SIDES;
      points.push(radius * cos(angle), y, -radius * sin(angle));
      if (ring === 0) continue;
      const next = (i + 1) % SIDES;
      const [a, b] = [(ring - 1) * SIDES + i, (ring - 1) * SIDES + next];
      const [c, d] = [ring * SIDES + i, ring * SIDES + next];
      index.push(a, b, d, a, d, c);
    }
  });
  return { points, index };
}
