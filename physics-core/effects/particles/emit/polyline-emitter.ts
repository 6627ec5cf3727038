import { lengthOf } from '../../../base/exact/index.js';
import type { Vec3 } from '../../../fields/types.js';
import { directionOf } from './directions.js';
import type { Emitter, Speeds } from './emitter.js';
import { areFinite, NOWHERE } from './finite.js';
import { emitterOf, type Place } from './place.js';
import { foundIn, sumsOf } from './sums.js';

export interface PolylineEmission extends Speeds {
  /** Flat xyz, metres. */
  points: readonly number[];
  /** X3D's coordIndex: -1 ends a line. With nothing but one -1, or nothing at all, all points in order are one line. */
  index: readonly number[];
  /** Of any length; 0 0 0: another for each particle. */
  direction: Vec3;
}

/** From places along lines, each length alike, in one direction. */
export function polylineEmitter({
  points,
  index,
  direction,
  ...speeds
}: PolylineEmission): Emitter {
  const place = areFinite(direction) && placeAlong(segmentsOf(points, index));
  return place ? emitterOf(place, directionOf(direction), speeds) : NOWHERE;
}

/** Numbers of a segment: where it begins, and the way to its end. */
const SEGMENT = 6;

/** None where an index is amiss; that of no point leaves numbers that are none. */
function segmentsOf(points: readonly number[], index: readonly number[]): number[] {
  const count = Math.floor(points.length / 3);
  const all = index.length === 0 || (index.length === 1 && index[0] === -1);
  const line = all ? Array.from({ length: count }, (_, i) => i) : index;
  const segments: number[] = [];
  for (let i = 0; i < line.length; i++) {
    const corner = line[i]!;
    if (corner === -1) continue;
    if (!Number.isInteger(corner)) return [];
    const from = i > 0 && line[i - 1] !== -1 ? line[i - 1]! : corner;
    for (let k = 0; k < 3; k++) segments.push(points[3 * from + k]!);
    for (let k = 0; k < 3; k++) segments.push(points[3 * corner + k]! - points[3 * from + k]!);
  }
  return segments;
}

/** Undefined where the length is none, or no number. Segments without one are found by no share. */
function placeAlong(list: number[]): Place | undefined {
  const segments = Float64Array.from(list);
  const sums = sumsOf(
    Array.from({ length: segments.length / SEGMENT }, (_, i) =>
      lengthOf(segments.subarray(i * SEGMENT + 3, (i + 1) * SEGMENT)),
    ),
  );
  const length = sums.at(-1) ?? 0;
  if (!(length > 0 && Number.isFinite(length))) return undefined;
  return (draws, birth) => {
    const at = SEGMENT * foundIn(sums, draws.next());
    const share = draws.next();
    for (let k = 0; k < 3; k++) birth[k] = segments[at + k]! + share * segments[at + 3 + k]!;
    return true;
  };
}
