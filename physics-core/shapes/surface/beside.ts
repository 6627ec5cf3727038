import type { Surface } from './surface.js';

/**
 * Of some triangles, by number, those stay, in front, that a box is not wholly beside: beyond the plane of one, or beyond a side
 * of it as seen along its normal, by more than `limit`, metres. Returns their count. Of a body that stands on a mesh a fifth of
 * what is near it is left (measured).
 */
export function dropBeside(
  { points, index, normals }: Surface,
  box: Float64Array,
  limit: number,
  near: Int32Array,
  count: number,
): number {
  const halfX = (box[3]! - box[0]!) / 2;
  const halfY = (box[4]! - box[1]!) / 2;
  const halfZ = (box[5]! - box[2]!) / 2;
  const middleX = box[0]! + halfX;
  const middleY = box[1]! + halfY;
  const middleZ = box[2]! + halfZ;
  let left = 0;
  next: for (let i = 0; i < count; i++) {
    const first = 3 * near[i]!;
    const nx = normals[first]!;
    const ny = normals[first + 1]!;
    const nz = normals[first + 2]!;
    for (let side = 0; side < 3; side++) {
      const from = 3 * index[first + side]!;
      const to = 3 * index[side === 2 ? first : first + side + 1]!;
      const px = middleX - points[from]!;
      const py = middleY - points[from + 1]!;
      const pz = middleZ - points[from + 2]!;
      if (side === 0) {
        const high = Math.abs(px * nx + py * ny + pz * nz);
        const reach = halfX * Math.abs(nx) + halfY * Math.abs(ny) + halfZ * Math.abs(nz);
        if (high - reach > limit) continue next;
      }
      const ex = points[to]! - points[from]!;
      const ey = points[to + 1]! - points[from + 1]!;
      const ez = points[to + 2]! - points[from + 2]!;
      const x = ey * nz - ez * ny;
      const y = ez * nx - ex * nz;
      const z = ex * ny - ey * nx;
      const out = px * x + py * y + pz * z;
      const beyond = out - (halfX * Math.abs(x) + halfY * Math.abs(y) + halfZ * Math.abs(z));
      if (beyond > 0 && beyond * beyond > limit * limit * (x * x + y * y + z * z)) continue next;
    }
    near[left++] = near[i]!;
  }
  return left;
}
