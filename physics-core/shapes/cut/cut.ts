/** Numbers, one after the other. */
export type Flat = Float64Array;

/** Where the numbers of a plane lie: its normal, a unit vector, and how far it is from the origin along that, metres. */
export const PLANE = { normal: 0, offset: 3 } as const;

/**
 * Where the numbers of what lies below a plane, on the other side than its normal, lie: the volume, m³; that times where its
 * middle is, x y z, m⁴; and the area that it cuts out of the plane, m².
 */
export const BELOW = { volume: 0, moment: 1, area: 4 } as const;

/** How many those are. */
export const CUT = 5;

/** A solid that planes cut, in its own frame. */
export interface Cuttable {
  below(plane: Flat, out: Flat): void;
}
