import { levels } from '../../../../physics-core/dynamics/levels.js';
import type { World } from '../../../../physics-core/inside.js';
import type { Node, Vec3 } from '../../helpers.js';

/** m/s² of the worlds of these facts. */
export const G = 9.8;

export const LEVELS = levels.map(({ name }) => name);

export const DOWN: Vec3 = [0, -1, 0];

/** A straight line of links of one length, so long in all, from a point along a direction. */
export const line = (links: number, length: number, from: Vec3, along: Vec3): Vec3[] =>
  Array.from({ length: links + 1 }, (_, i): Vec3 => {
    const way = (length * i) / links;
    return [from[0] + way * along[0], from[1] + way * along[1], from[2] + way * along[2]];
  });

/** It touches nothing unless it is given a radius. */
export const addRope = (
  to: World,
  points: readonly Vec3[],
  fields: Record<string, unknown> = {},
): Node => to.add('Rope', { points, radius: 0, ...fields });

/** Ties a point of a rope to what the fields say: the world, or a body. */
export const tie = (
  to: World,
  softBody: Node,
  index: number,
  fields: Record<string, unknown> = {},
): Node => to.add('SoftBodyAttachment', { softBody, index, ...fields });

export const places = (rope: Node): Vec3[] => rope.get('positions') as Vec3[];

export const place = (rope: Node, i: number): Vec3 => places(rope).at(i)!;

/** What a rope has in all, J, as its places say: between the last three steps. */
export function energyOf(
  [before, now, after]: readonly Vec3[][],
  masses: readonly number[],
  dt: number,
): number {
  let sum = 0;
  now!.forEach(([, y], i) => {
    let square = 0;
    for (let k = 0; k < 3; k++) square += ((after![i]![k]! - before![i]![k]!) / (2 * dt)) ** 2;
    sum += masses[i]! * (square / 2 + G * y);
  });
  return sum;
}
