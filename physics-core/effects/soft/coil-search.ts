import { dot3 } from '../../base/flat-math.js';
import type { Coils } from '../../solver/ropes/coils.js';
import type { Strand } from '../../solver/ropes/strand.js';
import { COIL_RETURN, COIL_SIDE } from '../../solver/tolerances.js';
import type { Rope } from './rope.js';

const a = new Float64Array(3);
const b = new Float64Array(3);
/** From a place on the second link to one on the first. */
const way = new Float64Array(3);

/**
 * Finds where a rope may meet itself in a step that begins. Two links may do so in more than one place, as those that lie side
 * by side do at either end: so each point is looked at with each link, and links that cross with each other. They stay as far
 * apart as the rope is thick, or as they were laid.
 */
export class CoilSearch {
  /** Of each link, the box that it may be in; and links in the order of where their boxes begin. */
  #low = new Float64Array(0);
  #high = new Float64Array(0);
  #order = new Int32Array(0);
  /** How far along the rope each point is, and how far away each link looks, metres. */
  #along = new Float64Array(0);
  #reaches = new Float64Array(0);
  /** What links gave each other in the last step, N s, and where that stands by the numbers of both. */
  #given = new Float64Array(0);
  readonly #before = new Map<number, number>();
  /** In this look. */
  #strand!: Strand;
  #coils!: Coils;
  #laid: ArrayLike<number> = [];
  #radius = 0;
  /** A gap that is deeper when the step begins is taken for this one, metres. */
  #deepest = 0;

  /** `reaches`: how far away each point looks for something, metres. */
  look({ strand, settings }: Rope, coils: Coils, reaches: Float64Array, dt: number): void {
    this.#strand = strand;
    this.#coils = coils;
    this.#laid = settings.points;
    this.#radius = settings.radius;
    this.#deepest = -COIL_RETURN * dt;
    this.#keep();
    coils.clear();
    coils.friction = settings.friction;
    this.#lookAround(this.#bound(reaches));
  }

  #keep(): void {
    const { presses, rubs, normals, links, count } = this.#coils;
    this.#before.clear();
    if (this.#given.length < 3 * count) this.#given = new Float64Array(6 * count);
    for (let c = 0; c < count; c++) {
      if (presses[c] === 0) continue;
      const key = this.#keyOf(links[2 * c]!, links[2 * c + 1]!);
      const known = this.#before.get(key);
      const at = known ?? 3 * c;
      if (known === undefined) this.#given.fill(0, at, at + 3);
      for (let k = 0; k < 3; k++)
        this.#given[at + k]! += presses[c]! * normals[3 * c + k]! + rubs[3 * c + k]!;
      this.#before.set(key, at);
    }
  }

  #keyOf(i: number, j: number): number {
    return i * this.#strand.points + j;
  }

  /** Boxes; returns the axis along which the rope is longest. */
  #bound(reaches: Float64Array): number {
    const { places, lengths, points } = this.#strand;
    const links = points - 1;
    if (this.#along.length < points) this.#grow(2 * points);
    this.#along[0] = 0;
    for (let i = 0; i < links; i++) {
      this.#along[i + 1] = this.#along[i]! + lengths[i]!;
      this.#reaches[i] = Math.max(reaches[i]!, reaches[i + 1]!);
      for (let k = 3 * i; k < 3 * i + 3; k++) {
        this.#low[k] = Math.min(places[k]!, places[k + 3]!) - this.#reaches[i]!;
        this.#high[k] = Math.max(places[k]!, places[k + 3]!) + this.#reaches[i]!;
      }
    }
    let axis = 0;
    let longest = -1;
    for (let k = 0; k < 3; k++) {
      let least = Infinity;
      let most = -Infinity;
      for (let i = 0; i < points; i++) {
        least = Math.min(least, places[3 * i + k]!);
        most = Math.max(most, places[3 * i + k]!);
      }
      if (!(most - least > longest)) continue;
      longest = most - least;
      axis = k;
    }
    return axis;
  }

  #grow(points: number): void {
    this.#low = new Float64Array(3 * points);
    this.#high = new Float64Array(3 * points);
    this.#order = new Int32Array(points);
    this.#along = new Float64Array(points);
    this.#reaches = new Float64Array(points);
  }

  /** Links whose boxes meet. */
  #lookAround(axis: number): void {
    const low = this.#low;
    const high = this.#high;
    const links = this.#strand.points - 1;
    const order = this.#order.subarray(0, links);
    for (let i = 0; i < links; i++) order[i] = i;
    order.sort((i, j) => low[3 * i + axis]! - low[3 * j + axis]! || i - j);
    for (let n = 0; n < links; n++)
      for (let m = n + 1; m < links; m++) {
        const i = order[n]!;
        const j = order[m]!;
        if (low[3 * j + axis]! > high[3 * i + axis]!) break;
        if (this.#boxesMeet(i, j)) this.#meet(Math.min(i, j), Math.max(i, j));
      }
  }

  #boxesMeet(i: number, j: number): boolean {
    for (let k = 0; k < 3; k++) {
      if (this.#low[3 * i + k]! > this.#high[3 * j + k]!) return false;
      if (this.#low[3 * j + k]! > this.#high[3 * i + k]!) return false;
    }
    return true;
  }

  /** Where they cross, and each point with the other link: ends of links that both share once. */
  #meet(i: number, j: number): void {
    const last = this.#strand.points - 2;
    if (this.#along[j + 1]! - this.#along[i]! < Math.PI * this.#radius) return;
    this.#cross(i, j);
    this.#point(i, 0, j, true);
    this.#point(j, 0, i, false);
    if (j === last) this.#point(j, 1, i, false);
  }

  /** Where two links are nearest between their ends (Ericson, Real-Time Collision Detection, 5.1.9). */
  #cross(i: number, j: number): void {
    const { places } = this.#strand;
    for (let k = 0; k < 3; k++) {
      a[k] = places[3 * i + 3 + k]! - places[3 * i + k]!;
      b[k] = places[3 * j + 3 + k]! - places[3 * j + k]!;
      way[k] = places[3 * i + k]! - places[3 * j + k]!;
    }
    const aa = dot3(a, 0, a, 0);
    const bb = dot3(b, 0, b, 0);
    const ab = dot3(a, 0, b, 0);
    const ar = dot3(a, 0, way, 0);
    const br = dot3(b, 0, way, 0);
    const across = aa * bb - ab * ab;
    const s = (ab * br - ar * bb) / across;
    const t = (aa * br - ab * ar) / across;
    if (s > 0 && s < 1 && t > 0 && t < 1) this.#note(i, s, j, t);
  }

  /** The first point of a link, or its last, with another link. `ends`: or with that one's first point. */
  #point(i: number, s: number, j: number, ends: boolean): void {
    const { places, points } = this.#strand;
    let along = 0;
    let square = 0;
    for (let k = 0; k < 3; k++) {
      const own = places[3 * j + 3 + k]! - places[3 * j + k]!;
      along += own * (places[3 * (i + s) + k]! - places[3 * j + k]!);
      square += own * own;
    }
    const t = Math.min(1, Math.max(0, along / square));
    if ((t > 0 && t < 1) || (ends && (t === 0 || j === points - 2))) this.#note(i, s, j, t);
  }

  /** If it is near. What is nearer along the rope than half round a circle as tight as itself is bent, and in no one's way. */
  #note(i: number, s: number, j: number, t: number): void {
    const first = this.#along[i]! + s * (this.#along[i + 1]! - this.#along[i]!);
    const second = this.#along[j]! + t * (this.#along[j + 1]! - this.#along[j]!);
    if (Math.abs(second - first) < Math.PI * this.#radius) return;
    const thick = Math.min(2 * this.#radius, awayFrom(this.#laid, i, s, j, t));
    const far = awayFrom(this.#strand.places, i, s, j, t);
    if (!(far > 0) || far < COIL_SIDE * thick) return;
    if (!(far < this.#reaches[i]! + this.#reaches[j]!)) return;
    const c = this.#coils.add(i, j, s, t);
    const { normals, gaps } = this.#coils;
    for (let k = 0; k < 3; k++) normals[3 * c + k] = way[k]! / far;
    gaps[c] = Math.max(far - thick, this.#deepest);
    this.#inherit(c, i, j);
  }

  /** It gives what it gave in the last step, there or at a link beside: it may have slid on. */
  #inherit(c: number, i: number, j: number): void {
    const at =
      this.#take(i, j) ??
      this.#take(i - 1, j) ??
      this.#take(i + 1, j) ??
      this.#take(i, j - 1) ??
      this.#take(i, j + 1);
    if (at === undefined) return;
    const { normals, presses, rubs } = this.#coils;
    const press = dot3(this.#given, at, normals, 3 * c);
    presses[c] = Math.max(0, press);
    for (let k = 0; k < 3; k++)
      rubs[3 * c + k] = this.#given[at + k]! - press * normals[3 * c + k]!;
  }

  #take(i: number, j: number): number | undefined {
    const key = this.#keyOf(i, j);
    const at = this.#before.get(key);
    if (at !== undefined) this.#before.delete(key);
    return at;
  }
}

/** How far a place on one link is from one on another, metres; the way from the second to `way`. */
function awayFrom(places: ArrayLike<number>, i: number, s: number, j: number, t: number): number {
  for (let k = 0; k < 3; k++) {
    const p = places[3 * i + k]!;
    const q = places[3 * j + k]!;
    way[k] = p + s * (places[3 * i + 3 + k]! - p) - q - t * (places[3 * j + 3 + k]! - q);
  }
  return Math.sqrt(dot3(way, 0, way, 0));
}
