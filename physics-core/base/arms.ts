// What a body does at the end of an arm from its centre of mass: a place in flat arrays, three numbers from an index on. How
// the body moves, or is pushed, are six: linear, then angular.

/** How fast the end of the arm moves along x, of a body that moves as `v[i]` and the five behind it say. */
export const armVelocityX = (v: Float64Array, i: number, arm: Float64Array, j: number): number =>
  v[i]! + v[i + 4]! * arm[j + 2]! - v[i + 5]! * arm[j + 1]!;

/** Along y. */
export const armVelocityY = (v: Float64Array, i: number, arm: Float64Array, j: number): number =>
  v[i + 1]! + v[i + 5]! * arm[j]! - v[i + 3]! * arm[j + 2]!;

/** Along z. */
export const armVelocityZ = (v: Float64Array, i: number, arm: Float64Array, j: number): number =>
  v[i + 2]! + v[i + 3]! * arm[j + 1]! - v[i + 4]! * arm[j]!;

/** Adds a push (x y z) at the end of the arm to the six numbers from `to[i]` on: itself, and arm × push. */
export function addWrench(
  to: Float64Array,
  i: number,
  arm: Float64Array,
  j: number,
  x: number,
  y: number,
  z: number,
): void {
  const rx = arm[j]!;
  const ry = arm[j + 1]!;
  const rz = arm[j + 2]!;
  to[i]! += x;
  to[i + 1]! += y;
  to[i + 2]! += z;
  to[i + 3]! += ry * z - rz * y;
  to[i + 4]! += rz * x - rx * z;
  to[i + 5]! += rx * y - ry * x;
}
