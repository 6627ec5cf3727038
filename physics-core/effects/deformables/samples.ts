import { longest } from '../../solver/deformables/between.js';
import { FINEST } from './tolerances.js';

/** Points of a surface between those of its geometry: on its edges, and within its triangles where these are large. */
export interface Samples {
  readonly count: number;
  /** Three points of the surface for each, and what share each of them has. */
  readonly points: Int32Array;
  readonly weights: Float64Array;
}

/**
 * So close that what lies over an edge of a body, bent at a right angle, is no deeper there than it is thick: samples s apart
 * cut s / 2 off.
 */
export function samplesOf(places: Float64Array, triangles: Int32Array, thickness: number): Samples {
  const points: number[] = [];
  const weights: number[] = [];
  const known = new Set<string>();
  if (!(thickness > 0))
    return { count: 0, points: new Int32Array(0), weights: new Float64Array(0) };
  for (let f = 0; f + 2 < triangles.length; f += 3) {
    const face = [triangles[f]!, triangles[f + 1]!, triangles[f + 2]!];
    const order = Math.min(FINEST, Math.ceil(longest(places, face) / (2 * thickness)));
    for (let a = 0; a <= order; a++)
      for (let b = 0; a + b <= order; b++) {
        const shares = [a, b, order - a - b];
        const used = shares.filter((share) => share > 0).length;
        if (used < 2) continue;
        if (used === 2 && isKnown(known, face, shares)) continue;
        points.push(...face);
        weights.push(...shares.map((share) => share / order));
      }
  }
  return {
    count: weights.length / 3,
    points: Int32Array.from(points),
    weights: Float64Array.from(weights),
  };
}

/** On an edge, which has two triangles: it is there already. */
function isKnown(known: Set<string>, face: readonly number[], shares: readonly number[]): boolean {
  const key = face
    .map((point, k) => [point, shares[k]!] as const)
    .filter(([, share]) => share > 0)
    .sort(([a], [b]) => a - b)
    .join(' ');
  if (known.has(key)) return true;
  known.add(key);
  return false;
}
