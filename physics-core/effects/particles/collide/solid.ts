/** Numbers, one after the other. */
export type Flat = Float64Array;

/**
 * A straight way in the frame of a solid: where its middle begins, x y z, and how far it goes, x y z, metres; then the radius
 * of what goes there, 0 for a point, and the share of it after which nothing is asked for. All that is handed on stands in
 * such lists: a number that a function is called with is made anew on the heap, if that is not part of who calls it.
 */
export const WAY = 8;

/** What is found on it: the share of the way, the depth in which it begins, metres, and the outward normal. */
export const FOUND = 5;

/** What is so near to a surface, metres, lies on it: ten thousand times what doubles round off 10 km from the origin. */
export const TOUCH = 1e-9;

/** A surface that is searched for step by step is found as near as this, metres. */
const EXACT = 1e-11;

/** What goes along a surface and comes nearer by less than this all the way, metres, is parallel to it. */
export const PARALLEL = 1e-12;

/** Steps of a search, each of which squares the error; where a way grazes a surface each takes a quarter of it. */
const MOST_STEPS = 40;

/** Something that ways meet, in its own frame. */
export interface Solid {
  /** Around it: least x y z, greatest x y z. */
  readonly box: Flat;
  /**
   * Where what goes on a way touches it first. Who begins inside touches at 0, and the depth is how far it has to go along
   * the normal until it only touches. Who begins in touch and goes away, or along, is not met. The last two numbers of the
   * way may be others afterwards.
   */
  meets(way: Flat, found: Flat): boolean;
}

/** The share at which a way enters, the normal there, and 1 where that is where it touches, not only what is around it. */
export const ENTRY = 5;

const entry = new Float64Array(ENTRY);
/** The normal where a surface is nearest, and how far it is, metres. */
const nearest = new Float64Array(4);
const at = new Float64Array(3);

export function write(
  found: Flat,
  share: number,
  depth: number,
  x: number,
  y: number,
  z: number,
): true {
  found[0] = share;
  found[1] = depth;
  found[2] = x;
  found[3] = y;
  found[4] = z;
  return true;
}

/** How far a surface is from a point. */
export interface Distance {
  /** Writes the outward normal of where it is nearest, and how far that is, metres, below 0 inside. */
  gap(at: Flat, out: Flat): void;
}

/** By how much a way comes nearer. */
const slopeOf = (normal: Flat, from: number, way: Flat): number =>
  normal[from]! * way[3]! + normal[from + 1]! * way[4]! + normal[from + 2]! * way[5]!;

const touch = (found: Flat, share: number, depth: number): true =>
  write(found, share, depth, nearest[0]!, nearest[1]!, nearest[2]!);

/**
 * From the share on that `found` says, at which it does not touch. The distance from something convex is a convex function
 * along a straight way: its tangent lies below it, so that Newton's steps never leap over the surface.
 */
export function approach(solid: Distance, way: Flat, found: Flat): boolean {
  let share = found[0]!;
  for (let i = 0; i < MOST_STEPS; i++) {
    for (let k = 0; k < 3; k++) at[k] = way[k]! + way[3 + k]! * share;
    solid.gap(at, nearest);
    const gap = nearest[3]! - way[6]!;
    const slope = slopeOf(nearest, 0, way);
    if (!(slope < 0)) return false;
    if (gap <= EXACT) break;
    const next = share - gap / slope;
    if (!(next <= way[7]!)) return false;
    if (next <= share) break;
    share = next;
  }
  return touch(found, share, 0);
}

/** Where it begins in or at something convex, or so near that its edges and corners have to be looked at. */
export function begin(solid: Distance, way: Flat, found: Flat): boolean {
  for (let k = 0; k < 3; k++) at[k] = way[k]!;
  solid.gap(at, nearest);
  const gap = nearest[3]! - way[6]!;
  found[0] = 0;
  if (gap > EXACT) return approach(solid, way, found);
  if (gap >= -TOUCH && !(slopeOf(nearest, 0, way) < -PARALLEL)) return false;
  return touch(found, 0, gap < 0 ? -gap : 0);
}

/**
 * Something convex without holes. A way is first cut off by the planes and surfaces that bound it, each moved out by the
 * radius: that is exact but for what rolls over edges and corners.
 */
export abstract class Convex implements Solid, Distance {
  abstract readonly box: Flat;

  /** Where a way enters what is bounded so, into `out`; below 0 where it begins inside. False: it does not come in. */
  protected abstract cut(way: Flat, out: Flat): boolean;

  abstract gap(at: Flat, out: Flat): void;

  meets(way: Flat, found: Flat): boolean {
    if (!this.cut(way, entry)) return false;
    const share = entry[0]!;
    if (share > 0) {
      found[0] = share;
      if (entry[4] === 0) return approach(this, way, found);
      return write(found, share, 0, entry[1]!, entry[2]!, entry[3]!);
    }
    // A point on an edge lies on both sides of it: it goes into the one that it enters. So it finds no gap between tiles.
    if (way[6]! <= TOUCH && share > -Infinity) {
      const slope = slopeOf(entry, 1, way);
      const depth = share * slope;
      if (slope < -PARALLEL && depth <= TOUCH)
        return write(found, 0, depth, entry[1]!, entry[2]!, entry[3]!);
    }
    return begin(this, way, found);
  }
}
