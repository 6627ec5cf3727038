import type { Masses } from './masses.js';

/**
 * The points of a surface as its author laid them, each a mean of points that have mass: of one of them where it is one
 * itself (cloth), of the corners of a cell where that carries it (a soft body).
 */
export class Surface {
  readonly count: number;
  /** So many of them are its author's: those come first. The others are only there to touch. */
  shown: number;
  /** Three of its points for each triangle. */
  readonly triangles: Int32Array;
  readonly #laid: Int32Array;
  /** How many points of mass carry each. */
  readonly width: number;
  /** Which, `width` for each, and what share each has. */
  readonly carriers: Int32Array;
  readonly shares: Float64Array;
  /** Where its points are, metres. */
  readonly places: Float64Array;

  constructor(
    triangles: ArrayLike<number>,
    width: number,
    carriers: ArrayLike<number>,
    shares: ArrayLike<number>,
  ) {
    this.width = width;
    this.count = carriers.length / width;
    this.shown = this.count;
    this.triangles = Int32Array.from(triangles);
    this.#laid = this.triangles.slice();
    this.carriers = Int32Array.from(carriers);
    this.shares = Float64Array.from(shares);
    this.places = new Float64Array(3 * this.count);
  }

  /** Only these of its triangles are there any more: of others all corners are its first point. */
  keep(isThere: (triangle: number) => boolean): void {
    for (let j = 0; j < this.triangles.length; j++)
      this.triangles[j] = isThere(Math.floor(j / 3)) ? this.#laid[j]! : 0;
  }

  /** Follows those that carry it. */
  follow({ places }: Masses): void {
    const { width, carriers, shares } = this;
    this.places.fill(0);
    for (let i = 0; i < this.count; i++)
      for (let n = width * i; n < width * i + width; n++) {
        const j = 3 * carriers[n]!;
        const share = shares[n]!;
        for (let k = 0; k < 3; k++) this.places[3 * i + k]! += share * places[j + k]!;
      }
  }
}
