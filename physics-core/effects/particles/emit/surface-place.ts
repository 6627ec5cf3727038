import { lengthOf } from '../../../base/exact/index.js';
import { cross, subtract } from '../../../base/math.js';
import type { Vec3 } from '../../../fields/types.js';
import type { Place } from './place.js';
import { foundIn, sumsOf } from './sums.js';
import { TRIANGLE } from './triangles.js';

/** Numbers of a face: its first corner, the ways to the two others, and its normal. */
const FACE = 12;

/**
 * Places on triangles, each area alike; where the velocity of a birth stands it leaves the triangle's normal, which looks
 * to where its corners go round counter-clockwise. Undefined where there is no area.
 */
export function placeOn(triangles: Float64Array): Place | undefined {
  const list: number[] = [];
  const areas: number[] = [];
  for (let at = 0; at < triangles.length; at += TRIANGLE) {
    const [a, b, c] = [0, 3, 6].map((i) => [...triangles.subarray(at + i, at + i + 3)]) as Vec3[];
    const [ab, ac] = [subtract(b!, a!), subtract(c!, a!)];
    const normal = cross(ab, ac);
    const size = lengthOf(normal);
    if (!(size > 0)) continue;
    list.push(...a!, ...ab, ...ac, ...normal.map((value) => value / size));
    areas.push(size / 2);
  }
  const sums = sumsOf(areas);
  return Number.isFinite(sums.at(-1)) ? placeOnFaces(Float64Array.from(list), sums) : undefined;
}

function placeOnFaces(faces: Float64Array, sums: Float64Array): Place {
  return (draws, birth) => {
    const at = FACE * foundIn(sums, draws.next());
    let toB = draws.next();
    let toC = draws.next();
    if (toB + toC > 1) {
      // Beyond the middle of the parallelogram: turned back into the triangle.
      toB = 1 - toB;
      toC = 1 - toC;
    }
    for (let k = 0; k < 3; k++) {
      birth[k] = faces[at + k]! + toB * faces[at + 3 + k]! + toC * faces[at + 6 + k]!;
      birth[3 + k] = faces[at + 9 + k]!;
    }
    return true;
  };
}
