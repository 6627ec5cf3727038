import { Apart } from './apart.js';
import { Corners } from './corners.js';
import { distance, edgesOf } from './edges.js';
import { Hinges } from './hinges.js';
import { Masses } from './masses.js';
import type { Material } from './material.js';
import { Surface } from './surface.js';
import { Threads } from './threads.js';
import { LEAST_SOFT_PARTS, MOST_SOFT_PARTS, FOLLOWED } from '../tolerances.js';
import { weld } from './weld.js';

/** What the author of a cloth says: kg; N/m; N m; a share. */
export interface ClothWords {
  readonly mass: number;
  /** 0: it does not stretch. */
  readonly stretch: number;
  readonly shear: number;
  readonly bend: number;
  /** 0: it never tears. */
  readonly tear: number;
}

/** A sheet of threads. */
export class Cloth implements Material {
  readonly masses: Masses;
  readonly surface: Surface;
  readonly side = 0;
  readonly #threads: Threads;
  readonly #corners: Corners;
  readonly #hinges: Hinges;
  readonly #apart: Apart;
  /** Of each point 1/s² for each N/m, N/m and N m: what the fastest of each kind are answered by. */
  readonly #shearRate: number;
  readonly #bendRate: number;
  /** 1: a triangle that borders a torn thread; of those that have an area. Which of the surface each is. */
  readonly #gone: Uint8Array;
  readonly #numbers: readonly number[];
  #words: ClothWords = { mass: 1, stretch: 0, shear: 0, bend: 0, tear: 0 };
  /** Threads go to their length instead of pulling there: they would be too fast. */
  #held = true;
  #shear = 0;
  #bend = 0;

  constructor(points: ArrayLike<number>, index: ArrayLike<number>, mass: number) {
    const { places: all, numbers: carriers } = weld(points);
    const places = [...all];
    const { triangles, numbers } = wholeTriangles(index, [...carriers]);
    this.#numbers = numbers;
    this.#gone = new Uint8Array(numbers.length);
    const areas = areasOf(places, triangles);
    this.masses = new Masses(places);
    this.#weigh(triangles, areas);
    this.surface = new Surface(
      Array.from(index).slice(0, index.length - (index.length % 3)),
      1,
      carriers,
      new Float64Array(carriers.length).fill(1),
    );
    this.surface.follow(this.masses);
    const edges = edgesOf(places, triangles);
    this.#threads = new Threads(edges, areas, places);
    this.#corners = new Corners(places, triangles, areas, this.#threads);
    this.#hinges = new Hinges(places, edges, areas);
    this.#apart = new Apart(places, triangles);
    this.#shearRate = most(this.#rates((rates) => this.#corners.addRates(rates, this.masses)));
    this.#bendRate = most(this.#rates((rates) => this.#hinges.addRates(rates, this.masses)));
    this.masses.weigh(mass);
    this.masses.free();
  }

  /** Each triangle to its corners, to each what of it is nearest to that: squares weigh the same however they are cut. */
  #weigh(triangles: readonly number[], areas: Float64Array): void {
    const { masses, count, places } = this.masses;
    let whole = 0;
    for (const area of areas) whole += area;
    for (let f = 0; f < areas.length; f++) {
      const face = [0, 1, 2].map((k) => triangles[3 * f + k]!);
      nearestShares(places, face).forEach((share, k) => {
        masses[face[k]!]! += (share * areas[f]!) / whole;
      });
    }
    // What borders nothing that has an area weighs what the others do.
    for (let i = 0; i < count; i++) if (!(masses[i]! > 0)) masses[i] = 1 / count;
    this.masses.laid();
  }

  #rates(add: (rates: Float64Array) => void): Float64Array {
    const rates = new Float64Array(this.masses.count);
    add(rates);
    return rates;
  }

  say(words: ClothWords): void {
    if (words.mass !== this.masses.mass) this.masses.weigh(words.mass);
    this.#words = words;
    this.#shear = words.shear;
    this.#bend = words.bend;
  }

  /** Rates are those of 1 kg. */
  get #lightness(): number {
    return 1 / this.masses.mass;
  }

  get hull(): Surface {
    return this.surface;
  }

  /** Threads pull where a step can follow them, however they may come to lie; otherwise they are held. */
  parts(dt: number): number {
    const { stretch, shear, bend } = this.#words;
    const slow = this.#lightness * (shear * this.#shearRate + bend * this.#bendRate);
    const follow = (square: number): number => Math.ceil((dt * Math.sqrt(square)) / (2 * FOLLOWED));
    const pulled = (square: number): number => follow(slow + stretch * square);
    this.#held = !(stretch > 0) || pulled(this.#threads.quickest(this.masses)) > MOST_SOFT_PARTS;
    const parts = this.#held ? follow(slow) : pulled(this.#threads.quickestNow(this.masses));
    return Math.max(LEAST_SOFT_PARTS, parts);
  }

  soften(parts: number, dt: number): number {
    const { shear, bend } = this.#words;
    const slow = this.#lightness * (shear * this.#shearRate + bend * this.#bendRate);
    const share = Math.min(1, (2 * FOLLOWED * parts) ** 2 / (dt * dt * slow || 1));
    this.#shear = share * shear;
    this.#bend = share * bend;
    return share;
  }

  push(time: number): void {
    if (!this.#held) this.#threads.push(this.masses, this.#words.stretch, time);
    if (this.#shear > 0) this.#corners.push(this.masses, this.#shear, time, this.#gone);
    if (this.#bend > 0) this.#hinges.push(this.masses, this.#bend, time, this.#gone);
  }

  hold(time: number, again: boolean): void {
    if (this.#held) this.#threads.hold(this.masses, this.#words.stretch, time, again);
    const { tear } = this.#words;
    if (tear > 0 && this.#threads.tear(this.masses, tear)) this.restored();
  }

  /** A step of `dt` seconds begins: who may come near whom. */
  lookAtItself(thickness: number, dt: number): void {
    this.#apart.look(this.masses, thickness, dt, this.#gone);
  }

  keepApart(friction: number): void {
    this.#apart.hold(this.masses, friction);
  }

  /** Triangles go with the threads that they border. */
  restored(): void {
    const { torn, faces } = this.#threads;
    this.#gone.fill(0);
    faces.forEach((both, n) => {
      if (torn[n] === 1) for (const face of both) this.#gone[face] = 1;
    });
    const lost = new Set(this.#numbers.filter((_, face) => this.#gone[face] === 1));
    this.surface.keep((triangle) => !lost.has(triangle));
  }

  get lasting(): readonly Uint8Array[] {
    return [this.#threads.torn];
  }

  /** Of what does not stretch. */
  get stretched(): number {
    return this.#words.stretch > 0 ? 0 : this.#threads.stretched(this.masses);
  }

  get strain(): number {
    return this.#held ? this.#threads.strain : 0;
  }
}

/** Of each corner of a triangle the share that is nearest to it (Meyer and others, 2003: mixed Voronoi areas). */
function nearestShares(places: Float64Array, face: readonly number[]): number[] {
  const squares = face.map((_, k) => distance(places, face[(k + 1) % 3]!, face[(k + 2) % 3]!) ** 2);
  const sum = squares[0]! + squares[1]! + squares[2]!;
  const blunt = squares.findIndex((square) => 2 * square >= sum);
  if (blunt >= 0) return face.map((_, k) => (k === blunt ? 0.5 : 0.25));
  // A side's square times the cotangent of the angle across from it, by the area: in each an eighth of what lies along it.
  const parts = squares.map((square) => square * (sum - 2 * square));
  const all = 2 * (parts[0]! + parts[1]! + parts[2]!);
  return face.map((_, k) => (parts[(k + 1) % 3]! + parts[(k + 2) % 3]!) / all);
}

const most = (rates: ArrayLike<number>): number => {
  let greatest = 0;
  for (let i = 0; i < rates.length; i++) greatest = Math.max(greatest, rates[i]!);
  return greatest;
};

/** By the points that stand for them, without those that have two corners in one place, or corners that are no points. */
function wholeTriangles(
  index: ArrayLike<number>,
  carriers: readonly number[],
): { triangles: number[]; numbers: number[] } {
  const triangles: number[] = [];
  const numbers: number[] = [];
  for (let n = 0; n + 2 < index.length; n += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => carriers[index[n + k]!]);
    if (a === undefined || b === undefined || c === undefined) continue;
    if (a === b || b === c || c === a) continue;
    triangles.push(a, b, c);
    numbers.push(n / 3);
  }
  return { triangles, numbers };
}

function areasOf(places: readonly number[], triangles: readonly number[]): Float64Array {
  const areas = new Float64Array(triangles.length / 3);
  for (let f = 0; f < areas.length; f++) {
    const [a, b, c] = [0, 1, 2].map((k) => 3 * triangles[3 * f + k]!) as [number, number, number];
    const way = (p: number, k: number): number => places[p + k]! - places[a + k]!;
    const x = way(b, 1) * way(c, 2) - way(b, 2) * way(c, 1);
    const y = way(b, 2) * way(c, 0) - way(b, 0) * way(c, 2);
    const z = way(b, 0) * way(c, 1) - way(b, 1) * way(c, 0);
    areas[f] = Math.sqrt(x * x + y * y + z * z) / 2;
  }
  return areas;
}
