import { cos, sin } from '../../base/exact/index.js';

/** Of what is round. An odd number is as even as twice as many, since no two of them are opposite. */
const SIDES = 13;

const ANGLE = (2 * Math.PI) / SIDES;

/** By how much larger it is around, so that it is as wide as the circle, and over its ends, so that they are as large. */
const AROUND = ANGLE / 2 / sin(ANGLE / 2);
const ACROSS = Math.sqrt(ANGLE / sin(ANGLE));

/** Triangles around y, from `bottom` at y = -half to `top` at y = half. */
export function frustumSkin(bottom: number, top: number, half: number): number[] {
  const skin: number[] = [];
  const rim = (radius: number, y: number, i: number): number[] => [
    radius * sin(i * ANGLE),
    y,
    radius * cos(i * ANGLE),
  ];
  for (let i = 0; i < SIDES; i++) {
    const low = [rim(AROUND * bottom, -half, i), rim(AROUND * bottom, -half, i + 1)];
    const high = [rim(AROUND * top, half, i), rim(AROUND * top, half, i + 1)];
    if (bottom > 0) {
      skin.push(...low[0]!, ...low[1]!, ...high[1]!);
      skin.push(
        0,
        -half,
        0,
        ...rim(ACROSS * bottom, -half, i + 1),
        ...rim(ACROSS * bottom, -half, i),
      );
    }
    if (top > 0) {
      skin.push(...low[0]!, ...high[1]!, ...high[0]!);
      skin.push(0, half, 0, ...rim(ACROSS * top, half, i), ...rim(ACROSS * top, half, i + 1));
    }
  }
  return skin;
}
