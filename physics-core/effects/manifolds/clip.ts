import { MOST_CORNERS, type Flat } from '../../shapes/forms/form.js';

/** Corners of two faces, one clipped against the other, at most. */
export const MOST_CLIPPED = 2 * MOST_CORNERS;

/** So far outside a side a corner still counts as on it, metres: rounding, and faces that end in the same line. */
const ON = 1e-7;

const other = new Float64Array(3 * MOST_CLIPPED);

/**
 * Sutherland and Hodgman 1974: what of a polygon, line or point lies over a convex face with the unit normal (x, y, z),
 * seen along it; in place. Returns the count of corners that are left.
 */
export function clip(
  subject: Flat,
  count: number,
  face: Flat,
  corners: number,
  x: number,
  y: number,
  z: number,
): number {
  let from = subject;
  let to: Flat = other;
  for (let i = 0; i < corners && count > 0; i++) {
    const a = 3 * i;
    const b = 3 * ((i + 1) % corners);
    const ex = face[b]! - face[a]!;
    const ey = face[b + 1]! - face[a + 1]!;
    const ez = face[b + 2]! - face[a + 2]!;
    // Out of the face, in its plane.
    let ox = ey * z - ez * y;
    let oy = ez * x - ex * z;
    let oz = ex * y - ey * x;
    const size = Math.sqrt(ox * ox + oy * oy + oz * oz);
    if (size === 0) continue;
    ox /= size;
    oy /= size;
    oz /= size;
    const edge = ox * face[a]! + oy * face[a + 1]! + oz * face[a + 2]! + ON;
    count = clipAt(from, count, ox, oy, oz, edge, to);
    const clipped = to;
    to = from;
    from = clipped;
  }
  if (from !== subject) for (let i = 0; i < 3 * count; i++) subject[i] = from[i]!;
  return count;
}

/** What lies behind a plane. */
function clipAt(
  from: Flat,
  count: number,
  x: number,
  y: number,
  z: number,
  edge: number,
  to: Flat,
): number {
  let left = 0;
  let last = 3 * (count - 1);
  let before = x * from[last]! + y * from[last + 1]! + z * from[last + 2]! - edge;
  for (let at = 0; at < 3 * count; at += 3) {
    const here = x * from[at]! + y * from[at + 1]! + z * from[at + 2]! - edge;
    if (here > 0 !== before > 0 && left < MOST_CLIPPED) {
      const share = before / (before - here);
      for (let i = 0; i < 3; i++)
        to[3 * left + i] = from[last + i]! + share * (from[at + i]! - from[last + i]!);
      left++;
    }
    if (here <= 0 && left < MOST_CLIPPED) {
      for (let i = 0; i < 3; i++) to[3 * left + i] = from[at + i]!;
      left++;
    }
    last = at;
    before = here;
  }
  return left;
}
