import type { Flat, Silhouette } from './silhouette.js';

/** Numbers of a triangle: its area along its normal, m², and its middle. */
const FACET = 6;

/**
 * What is bounded by triangles. Each line through something closed and convex enters and leaves it once, so that the side
 * that is turned to who looks shows what is seen, and so does the other one; of an open sheet it is the side that shows
 * more. What is hidden behind another part of it counts, too.
 */
export class FacetSilhouette implements Silhouette {
  readonly #facets: Flat;

  /** Points are flat, x y z; of each triangle the numbers of its corners, one after the other. */
  constructor(points: ArrayLike<number>, corners: readonly number[]) {
    const count = Math.floor(corners.length / 3);
    this.#facets = new Float64Array(FACET * count);
    for (let i = 0; i < count; i++) {
      const at = (corner: number, k: number): number => points[3 * corners[3 * i + corner]! + k]!;
      const side = (corner: number, k: number): number => at(corner, k % 3) - at(0, k % 3);
      for (let k = 0; k < 3; k++) {
        this.#facets[FACET * i + k] =
          (side(1, k + 1) * side(2, k + 2) - side(1, k + 2) * side(2, k + 1)) / 2;
        this.#facets[FACET * i + 3 + k] = (at(0, k) + at(1, k) + at(2, k)) / 3;
      }
    }
  }

  along(way: Flat, out: Flat): void {
    const facets = this.#facets;
    const u = way[0]!;
    const v = way[1]!;
    const w = way[2]!;
    // Of both sides: what they show together, and by how much the far one shows more. No call and no branch: there may be many.
    let both = 0;
    let bothX = 0;
    let bothY = 0;
    let bothZ = 0;
    let more = 0;
    let moreX = 0;
    let moreY = 0;
    let moreZ = 0;
    for (let i = 0; i < facets.length; i += FACET) {
      const turned = facets[i]! * u + facets[i + 1]! * v + facets[i + 2]! * w;
      const area = Math.abs(turned);
      const x = facets[i + 3]!;
      const y = facets[i + 4]!;
      const z = facets[i + 5]!;
      both += area;
      bothX += area * x;
      bothY += area * y;
      bothZ += area * z;
      more += turned;
      moreX += turned * x;
      moreY += turned * y;
      moreZ += turned * z;
    }
    const sign = more > 0 ? 1 : -1;
    out[0] = (both + sign * more) / 2;
    out[1] = (bothX + sign * moreX) / 2;
    out[2] = (bothY + sign * moreY) / 2;
    out[3] = (bothZ + sign * moreZ) / 2;
  }
}
