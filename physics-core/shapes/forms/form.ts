/** Numbers, three to a point. */
export type Flat = Float64Array;

/** Most corners that a form hands out of one face. */
export const MOST_CORNERS = 256;

/**
 * The exact outline of something convex as contacts need it, in its own frame. Directions are of any length unless said
 * to be units; corners go in order around a face.
 */
export interface Form {
  /** It reaches so far beyond what is said here, on all sides, metres: the radius of a ball around its middle. */
  readonly round: number;
  /** What of it lies on a plane are corners, which turn with it. */
  readonly cornered: boolean;
  /** From its frame's origin to what is farthest of it, metres. */
  readonly reach: number;
  /** The point farthest along a direction, which may lie in `out`: of all that is asked for most, as an array, so that no number is boxed. */
  support(direction: Flat, out: Flat): void;
  /** The outward normal, into `out`, of the flat face that looks most along a direction; its number, -1 without any. */
  facing(x: number, y: number, z: number, out: Flat): number;
  /** The corners of a flat face; their count. */
  face(number: number, out: Flat): number;
  /**
   * What would lie on a plane that it is pressed against along the unit vector (x, y, z): corners of a face, two ends of a
   * line, or a point; their count. Of a disc these are points of its rim, the first the lowest or, where it lies level,
   * the one along (u, v, w): they do not turn with the disc.
   */
  lying(x: number, y: number, z: number, u: number, v: number, w: number, out: Flat): number;
  /** Both ends of the straight line of its surface that is farthest along a unit vector; 2, or 1 where it is a point. */
  line(x: number, y: number, z: number, out: Flat): number;
}
