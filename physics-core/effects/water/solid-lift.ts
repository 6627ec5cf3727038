import type { Volume } from './volume.js';
import { LAYERS, LIFTS_ALIKE, THIN } from './tolerances.js';
import type { Braking } from './braking.js';
import { Heads } from './heads.js';
import type { WetSurface } from './matter.js';

const point = new Float64Array(3);
const middle = new Float64Array(2);

/**
 * What lifts a solid: each part of it by the weight of the water in its place, and none of it is squeezed, as in a sponge, or in
 * what keeps its volume. How much that is in all, and where its middle is, is known exactly by what the hull displaces: parts
 * are lifted by as much more or less from one side to the other.
 */
export class SolidLift {
  readonly #heads = new Heads();
  /** m³ that it displaces, and the same times how far that is along the first and the third axis of a volume. */
  #displaced = 0;
  #moments = new Float64Array(2);
  /** Of each point of mass: m³ below the surface. */
  #parts = new Float64Array(0);
  /** Sums over these: of themselves, times places, times their products. */
  readonly #sums = new Float64Array(6);

  /** A surface that is not closed displaces what makes no sense. */
  get #isKnown(): boolean {
    const even = this.#displaced / this.#sums[0]!;
    return even > 1 / LIFTS_ALIKE && even < LIFTS_ALIKE;
  }

  clear(): void {
    this.#displaced = 0;
    this.#moments.fill(0);
  }

  displace(volume: Volume, places: Float64Array, i: number, displaced: number): void {
    for (let k = 0; k < 3; k++) point[k] = places[3 * i + k]!;
    this.#displaced += displaced;
    this.#moments[0]! += displaced * volume.along(0, point);
    this.#moments[1]! += displaced * volume.along(2, point);
  }

  /** As much of it counts as of its hull. Answers what it displaces, m³. */
  spread({ masses, solid = 0 }: WetSurface, volume: Volume, hull: Heads, braking: Braking): number {
    const { count, places } = masses;
    const heads = this.#heads;
    heads.measure(volume, places, count, Infinity);
    heads.share = hull.share;
    heads.covered = hull.covered;
    if (hull.covered > 0) for (let i = 0; i < count; i++) heads.coverAs(hull, places, i);
    const high = Math.max(THIN, (hull.deepest - hull.highest) / LAYERS);
    this.#part(masses.masses, solid, high, count);
    this.#sum(volume, places, count);
    this.#push(volume, places, count, high, braking);
    return this.#isKnown ? this.#displaced : this.#sums[0]!;
  }

  #part(masses: Float64Array, solid: number, high: number, count: number): void {
    if (this.#parts.length < count) this.#parts = new Float64Array(count);
    let whole = 0;
    for (let i = 0; i < count; i++) whole += masses[i]!;
    for (let i = 0; i < count; i++)
      this.#parts[i] = ((solid * masses[i]!) / whole) * this.#heads.shareAt(i, high / 2);
  }

  #sum(volume: Volume, places: Float64Array, count: number): void {
    const sums = this.#sums;
    sums.fill(0);
    for (let i = 0; i < count; i++) {
      const part = this.#parts[i]!;
      if (part === 0) continue;
      for (let k = 0; k < 3; k++) point[k] = places[3 * i + k]!;
      const x = volume.along(0, point);
      const z = volume.along(2, point);
      sums[0]! += part;
      sums[1]! += part * x;
      sums[2]! += part * z;
      sums[3]! += part * x * x;
      sums[4]! += part * x * z;
      sums[5]! += part * z * z;
    }
  }

  #push(volume: Volume, places: Float64Array, count: number, high: number, braking: Braking): void {
    const { settings, gravity, up } = volume;
    const sums = this.#sums;
    const parts = this.#parts;
    if (!(sums[0]! > 0)) return;
    const even = this.#displaced / sums[0]!;
    const known = this.#isKnown;
    middle[0] = sums[1]! / sums[0]!;
    middle[1] = sums[2]! / sums[0]!;
    // By how much more along both axes, around the middle.
    const xx = sums[3]! - sums[1]! * middle[0];
    const xz = sums[4]! - sums[1]! * middle[1];
    const zz = sums[5]! - sums[2]! * middle[1];
    const px = this.#moments[0]! - this.#displaced * middle[0];
    const pz = this.#moments[1]! - this.#displaced * middle[1];
    const all = xx * zz - xz * xz;
    const leans = known && all > 1e-6 * xx * zz;
    const alongX = leans ? (px * zz - pz * xz) / all : 0;
    const alongZ = leans ? (pz * xx - px * xz) / all : 0;
    const down = Math.abs(gravity[0] * up[0] + gravity[1] * up[1] + gravity[2] * up[2]);
    for (let i = 0; i < count; i++) {
      const part = parts[i]!;
      if (part === 0) continue;
      for (let k = 0; k < 3; k++) point[k] = places[3 * i + k]!;
      const x = volume.along(0, point) - middle[0];
      const z = volume.along(2, point) - middle[1];
      const lifted = settings.density * part * ((known ? even : 1) + alongX * x + alongZ * z);
      for (let k = 0; k < 3; k++) braking.forces[3 * i + k]! -= lifted * gravity[k]!;
      braking.stiffs[i]! += (settings.density * part * down) / high;
    }
  }
}
