import type { Edge } from './edges.js';
import type { Masses } from './masses.js';

/**
 * Two triangles that meet at an edge: what bends them there takes ½ k e² / A |n|², with e the edge's length, A the area of
 * both and n the sum of their four points that is 0 as long as they are flat, and the angle between them where they are not
 * (Bergou and others, 2006: quadratic, so that no step gives it energy). A sheet of squares bent along its threads has ½ k κ².
 */
export class Hinges {
  readonly count: number;
  /** The ends of the edge, and the points across. */
  readonly #points: Int32Array;
  /** Both triangles. */
  readonly #faces: Int32Array;
  /** Of the four, what each counts for: metres to the power of 1/2 and -1. */
  readonly #weights: Float64Array;
  /** Half of what is not flat as it was laid stays so: n of that, along the mean normal. */
  readonly #rest: Float64Array;

  constructor(places: ArrayLike<number>, edges: readonly Edge[], areas: Float64Array) {
    const hinges = edges.filter(({ across, length }) => across.length === 2 && length > 0);
    this.count = hinges.length;
    this.#points = Int32Array.from(hinges.flatMap(({ a, b, across }) => [a, b, ...across]));
    this.#faces = Int32Array.from(hinges.flatMap(({ faces }) => faces));
    this.#weights = Float64Array.from(hinges.flatMap((hinge) => weightsOf(places, hinge, areas)));
    this.#rest = new Float64Array(this.count);
    for (let n = 0; n < this.count; n++) this.#rest[n] = this.#bent(places, n);
  }

  #bent(places: ArrayLike<number>, n: number): number {
    let square = 0;
    for (let k = 0; k < 3; k++) {
      let sum = 0;
      for (let p = 0; p < 4; p++)
        sum += this.#weights[4 * n + p]! * places[3 * this.#points[4 * n + p]! + k]!;
      square += sum * sum;
    }
    return Math.sqrt(square);
  }

  /** N m; what borders a triangle that is gone bends freely. */
  push(
    { places, velocities, inverse }: Masses,
    stiffness: number,
    time: number,
    gone: Uint8Array,
  ): void {
    const points = this.#points;
    const weights = this.#weights;
    for (let n = 0; n < this.count; n++) {
      if (gone[this.#faces[2 * n]!] === 1 || gone[this.#faces[2 * n + 1]!] === 1) continue;
      const at = 4 * n;
      const a = points[at]!;
      const b = points[at + 1]!;
      const c = points[at + 2]!;
      const d = points[at + 3]!;
      const wa = weights[at]!;
      const wb = weights[at + 1]!;
      const wc = weights[at + 2]!;
      const wd = weights[at + 3]!;
      let share = stiffness * time;
      const x =
        wa * places[3 * a]! + wb * places[3 * b]! + wc * places[3 * c]! + wd * places[3 * d]!;
      const y =
        wa * places[3 * a + 1]! +
        wb * places[3 * b + 1]! +
        wc * places[3 * c + 1]! +
        wd * places[3 * d + 1]!;
      const z =
        wa * places[3 * a + 2]! +
        wb * places[3 * b + 2]! +
        wc * places[3 * c + 2]! +
        wd * places[3 * d + 2]!;
      if (this.#rest[n]! > 0) {
        const now = Math.sqrt(x * x + y * y + z * z);
        share *= now > 0 ? 1 - this.#rest[n]! / now : 0;
      }
      const pa = share * wa * inverse[a]!;
      const pb = share * wb * inverse[b]!;
      const pc = share * wc * inverse[c]!;
      const pd = share * wd * inverse[d]!;
      velocities[3 * a]! -= pa * x;
      velocities[3 * a + 1]! -= pa * y;
      velocities[3 * a + 2]! -= pa * z;
      velocities[3 * b]! -= pb * x;
      velocities[3 * b + 1]! -= pb * y;
      velocities[3 * b + 2]! -= pb * z;
      velocities[3 * c]! -= pc * x;
      velocities[3 * c + 1]! -= pc * y;
      velocities[3 * c + 2]! -= pc * z;
      velocities[3 * d]! -= pd * x;
      velocities[3 * d + 1]! -= pd * y;
      velocities[3 * d + 2]! -= pd * z;
    }
  }

  addRates(rates: Float64Array, { masses }: Masses): void {
    for (let n = 0; n < this.count; n++) {
      let all = 0;
      for (let p = 0; p < 4; p++) all += Math.abs(this.#weights[4 * n + p]!);
      for (let p = 0; p < 4; p++) {
        const point = this.#points[4 * n + p]!;
        rates[point]! += (Math.abs(this.#weights[4 * n + p]!) * all) / masses[point]!;
      }
    }
  }
}

/** By the heights of the points across, and where these stand along the edge. */
function weightsOf(
  places: ArrayLike<number>,
  { a, b, across, faces, length }: Edge,
  areas: Float64Array,
): number[] {
  const out = [0, 0, 0, 0];
  const [one, other] = faces.map((f) => areas[f]!) as [number, number];
  if (!(one > 0 && other > 0)) return out;
  // e θ = sum of e (height of each point above the other's plane): at small angles.
  const root = 1 / Math.sqrt(one + other);
  across.forEach((c, i) => {
    const height = (2 * [one, other][i]!) / length;
    let along = 0;
    for (let k = 0; k < 3; k++)
      along +=
        ((places[3 * c + k]! - places[3 * a + k]!) * (places[3 * b + k]! - places[3 * a + k]!)) /
        length ** 2;
    const weight = (root * length) / height;
    out[2 + i]! += weight;
    out[0]! -= weight * (1 - along);
    out[1]! -= weight * along;
  });
  return out;
}
