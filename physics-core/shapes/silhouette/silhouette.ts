/** Numbers, one after the other. */
export type Flat = Float64Array;

/** Numbers of what is seen: its area, m², and that times where its middle lies, x y z, m³. */
export const SEEN = 4;

/** What is seen of a solid from far away, in its own frame. */
export interface Silhouette {
  /**
   * Seen along a unit vector, x y z, into `out`. Where along that the middle is said to lie is of no account: a push along
   * the vector does the same anywhere on it.
   */
  along(way: Flat, out: Flat): void;
}
