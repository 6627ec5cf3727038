import type { Ammo } from './ammo.js';
import { bodyAAt, bodyBAt, pointCountAt } from './manifold.js';
import { BODY, MANIFOLD, MANIFOLD_POINT as POINT, SHAPE, SHAPE_TYPE } from './offsets.js';

// Which parts of bodies of several parts a contact point is of.

/** Parts of a body, at most. */
const MOST_PARTS = 2 ** 24;

/** Whether a body is of several parts. */
export function isInParts({ HEAP32 }: Ammo, body: number): boolean {
  const shape = HEAP32[(body + BODY.shape) >> 2]!;
  return HEAP32[(shape + SHAPE.type) >> 2] === SHAPE_TYPE.compound;
}

/** Whether one of its bodies is. */
export const isOfParts = (ammo: Ammo, manifold: number): boolean =>
  isInParts(ammo, bodyAAt(ammo, manifold)) || isInParts(ammo, bodyBAt(ammo, manifold));

/** The number of a part, from what stands in a point: where a body is of one part, nobody wrote there. */
const partIn = (ammo: Ammo, body: number, index: number): number =>
  isInParts(ammo, body) ? index : 0;

/** Tells points of one pair apart by the parts that they are of. */
export const partsKey = (ammo: Ammo, a: number, b: number, index0: number, index1: number) =>
  partIn(ammo, a, index0) * MOST_PARTS + partIn(ammo, b, index1);

/** Sorts the manifolds of one pair by the parts that they are of; one without points comes first. */
export function partsKeyAt(ammo: Ammo, manifold: number): number {
  if (pointCountAt(ammo, manifold) === 0) return -1;
  const { HEAP32 } = ammo;
  const point = (manifold + MANIFOLD.points) >> 2;
  const index0 = HEAP32[point + POINT.index0 / 4]!;
  const index1 = HEAP32[point + POINT.index1 / 4]!;
  return partsKey(ammo, bodyAAt(ammo, manifold), bodyBAt(ammo, manifold), index0, index1);
}
