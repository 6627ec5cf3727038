import { dot3 } from '../../base/flat-math.js';
import { grown, grownInt } from '../../base/grown.js';
import type { Material } from '../../solver/deformables/material.js';
import { MET, METS, type Obstacles } from '../particles/collide/obstacles.js';
import type { Deformable } from './deformable.js';
import type { Guests } from './guests.js';
import { AHEAD, FLAT, NEARER, RETURN } from './tolerances.js';

const met = new Float64Array(METS);
const from = new Float64Array(3);
const to = new Float64Array(3);
const now = new Float64Array(3);
const was = new Float64Array(3);
/** Of a point of a body: since the step began, and in this part. */
const way = new Float64Array(6);
const push = new Float64Array(3);
const corners = new Float64Array(3);
const along = new Float64Array(3);

/** Corners of what touches: of a triangle, or of a point, three times the same. */
const CORNERS = 3;

/** Points and triangles of one surface, and what they touch in a step. */
export class Touches {
  count = 0;
  /** Points of the surface, and what share of what touches each is; how many of them there are, 1 or 3. */
  #points = new Int32Array(0);
  #weights = new Float64Array(0);
  #sizes = new Int32Array(0);
  #slots = new Int32Array(0);
  /** Outward normals, and points of the surfaces of bodies when the step begins. */
  #normals = new Float64Array(0);
  #bases = new Float64Array(0);
  /** How deep each was when the step began, metres, 0 or less. */
  #depths = new Float64Array(0);
  /** Of each point of the surface, its touch; -1: it has none. */
  #touchOf = new Int32Array(0);

  /** Bodies that it may touch, each as often as it does. */
  get slots(): Int32Array {
    return this.#slots.subarray(0, this.count);
  }

  /** Who may touch what in a step of `dt` seconds that begins. */
  look(deformable: Deformable, obstacles: Obstacles, guests: Guests, dt: number): void {
    this.count = 0;
    const { count } = deformable.material.surface;
    if (this.#touchOf.length < count) this.#touchOf = new Int32Array(count);
    this.#touchOf.fill(-1);
    if (!deformable.settings.touches) return;
    this.#lookAtPoints(deformable, obstacles, guests, dt);
    if (deformable.settings.radius > 0) this.#lookAtTriangles(deformable, obstacles, guests, dt);
  }

  #lookAtPoints(
    { material, settings: { radius }, within }: Deformable,
    obstacles: Obstacles,
    guests: Guests,
    dt: number,
  ): void {
    const { surface, masses } = material;
    const { count, width, carriers, shares, places } = surface;
    for (let i = 0; i < count; i++) {
      let square = 0;
      let held = true;
      for (let k = 0; k < 3; k++) from[k] = to[k] = places[3 * i + k]!;
      for (let n = width * i; n < width * i + width; n++) {
        const j = 3 * carriers[n]!;
        if (masses.inverse[carriers[n]!]! > 0) held = false;
        for (let k = 0; k < 3; k++) to[k]! += shares[n]! * dt * masses.velocities[j + k]!;
      }
      if (held) continue;
      for (let k = 0; k < 3; k++) square += (to[k]! - from[k]!) ** 2;
      const margin = AHEAD * radius + Math.sqrt(square);
      if (!meets(obstacles, radius, margin)) continue;
      if (within.get(i) === met[MET.body]!) continue;
      guests.add(met[MET.body]!, dt);
      this.#touchOf[i] = this.count;
      this.#note(from, radius, 1);
      this.#points[CORNERS * (this.count - 1)] = i;
      this.#weights[CORNERS * (this.count - 1)] = 1;
    }
  }

  /** Edges and corners of bodies come between points: where a triangle does not lie flat on what all of its points touch. */
  #lookAtTriangles(
    { material: { surface }, settings: { radius } }: Deformable,
    obstacles: Obstacles,
    guests: Guests,
    dt: number,
  ): void {
    const { triangles, places } = surface;
    for (let f = 0; f + 2 < triangles.length; f += 3) {
      if (this.#liesFlat(triangles, f)) continue;
      let reach = 0;
      for (let k = 0; k < 3; k++) {
        corners[k] = 1 / 3;
        from[k] =
          (places[3 * triangles[f]! + k]! +
            places[3 * triangles[f + 1]! + k]! +
            places[3 * triangles[f + 2]! + k]!) /
          3;
      }
      for (let n = 0; n < 3; n++) {
        let square = 0;
        for (let k = 0; k < 3; k++) square += (places[3 * triangles[f + n]! + k]! - from[k]!) ** 2;
        reach = Math.max(reach, square);
      }
      reach = Math.sqrt(reach) + (1 + AHEAD) * radius;
      if (!obstacles.isNear(from, from, reach)) continue;
      if (!nearest(obstacles, places, triangles, f, reach)) continue;
      let gap = -radius;
      for (let k = 0; k < 3; k++) gap += met[MET.normal + k]! * (from[k]! - met[MET.point + k]!);
      if (gap > AHEAD * radius) continue;
      guests.add(met[MET.body]!, dt);
      this.#note(from, radius, CORNERS);
      for (let n = 0; n < CORNERS; n++) {
        this.#points[CORNERS * (this.count - 1) + n] = triangles[f + n]!;
        this.#weights[CORNERS * (this.count - 1) + n] = corners[n]!;
      }
    }
  }

  #liesFlat(triangles: Int32Array, f: number): boolean {
    const a = this.#touchOf[triangles[f]!]!;
    if (a < 0) return false;
    for (let n = 1; n < 3; n++) {
      const b = this.#touchOf[triangles[f + n]!]!;
      if (b < 0 || this.#slots[a] !== this.#slots[b]) return false;
      if (dot3(this.#normals, 3 * a, this.#normals, 3 * b) < FLAT) return false;
    }
    return true;
  }

  #note(at: Float64Array, radius: number, size: number): void {
    this.#grow();
    const c = this.count++;
    this.#sizes[c] = size;
    this.#slots[c] = met[MET.body]!;
    let gap = -radius;
    for (let k = 0; k < 3; k++) {
      this.#normals[3 * c + k] = met[MET.normal + k]!;
      this.#bases[3 * c + k] = met[MET.point + k]!;
      gap += met[MET.normal + k]! * (at[k]! - met[MET.point + k]!);
    }
    this.#depths[c] = Math.min(0, gap);
  }

  #grow(): void {
    if (this.count < this.#slots.length) return;
    const room = 2 * this.count + 16;
    this.#points = grownInt(this.#points, CORNERS * room);
    this.#weights = grown(this.#weights, CORNERS * room);
    this.#sizes = grownInt(this.#sizes, room);
    this.#slots = grownInt(this.#slots, room);
    this.#normals = grown(this.#normals, 3 * room);
    this.#bases = grown(this.#bases, 3 * room);
    this.#depths = grown(this.#depths, room);
  }

  /** Whoever is too near is taken away, in a part of `time` seconds that ends `since` seconds after the step began. */
  hold(
    { material, settings: { radius, friction } }: Deformable,
    guests: Guests,
    time: number,
    since: number,
  ): void {
    for (let c = 0; c < this.count; c++) {
      const gives = this.#read(material, c);
      const slot = this.#slots[c]!;
      guests.wayOf(slot, this.#bases, 3 * c, way);
      let gap = -radius;
      for (let k = 0; k < 3; k++) {
        along[k] = this.#normals[3 * c + k]!;
        gap += along[k]! * (now[k]! - this.#bases[3 * c + k]! - way[k]!);
      }
      // What begins inside comes out in time.
      gap -= Math.min(0, this.#depths[c]! + RETURN * since);
      if (!(gap < 0) || !(gives > 0)) continue;
      const press = -gap / (gives + guests.gives(slot, this.#bases, 3 * c, along));
      for (let k = 0; k < 3; k++) push[k] = press * along[k]!;
      this.#rub(slot, c, friction * press, gives, guests);
      this.#push(material, c);
      for (let k = 0; k < 3; k++) push[k] = -push[k]!;
      guests.push(slot, this.#bases, 3 * c, push, time);
    }
  }

  /** Where what touches is, and was when the part began. Answers how it gives way, 1/kg. */
  #read({ surface: { width, carriers, shares }, masses }: Material, c: number): number {
    const { places, before, inverse } = masses;
    for (let k = 0; k < 3; k++) now[k] = was[k] = 0;
    let gives = 0;
    for (let n = CORNERS * c; n < CORNERS * c + this.#sizes[c]!; n++) {
      const weight = this.#weights[n]!;
      const first = width * this.#points[n]!;
      for (let m = first; m < first + width; m++) {
        const j = 3 * carriers[m]!;
        const share = weight * shares[m]!;
        gives += share * share * inverse[carriers[m]!]!;
        for (let k = 0; k < 3; k++) {
          now[k]! += share * places[j + k]!;
          was[k]! += share * before[j + k]!;
        }
      }
    }
    return gives;
  }

  #push({ surface: { width, carriers, shares }, masses }: Material, c: number): void {
    const { places, inverse } = masses;
    for (let n = CORNERS * c; n < CORNERS * c + this.#sizes[c]!; n++) {
      const weight = this.#weights[n]!;
      const first = width * this.#points[n]!;
      for (let m = first; m < first + width; m++) {
        const j = 3 * carriers[m]!;
        const share = weight * shares[m]! * inverse[carriers[m]!]!;
        for (let k = 0; k < 3; k++) places[j + k]! += share * push[k]!;
      }
    }
  }

  /** What went along the surface in this part goes back, as far as friction can take it. */
  #rub(slot: number, c: number, most: number, gives: number, guests: Guests): void {
    let out = 0;
    for (let k = 0; k < 3; k++) {
      now[k] = now[k]! - was[k]! - way[3 + k]!;
      out += now[k]! * along[k]!;
    }
    let square = 0;
    for (let k = 0; k < 3; k++) {
      now[k]! -= out * along[k]!;
      square += now[k]! * now[k]!;
    }
    if (!(square > 0)) return;
    const far = Math.sqrt(square);
    for (let k = 0; k < 3; k++) now[k]! /= far;
    const rub = Math.min(most, far / (gives + guests.gives(slot, this.#bases, 3 * c, now)));
    for (let k = 0; k < 3; k++) push[k]! -= rub * now[k]!;
  }
}

/** On its way, or near to it. */
function meets(obstacles: Obstacles, radius: number, margin: number): boolean {
  if (!obstacles.isNear(from, to, radius + margin)) return false;
  return (
    obstacles.meet(from, from, radius + margin, met, 1, 1) ||
    obstacles.meet(from, to, radius, met, 1, 1)
  );
}

/**
 * The point of a triangle that is nearest to what is around it: from its middle again and again towards the corner that lies
 * farthest against the normal there (Frank and Wolfe; Macklin and others, 2020). False: nothing is within reach of its middle.
 */
function nearest(
  obstacles: Obstacles,
  places: Float64Array,
  triangles: Int32Array,
  f: number,
  reach: number,
): boolean {
  for (let n = 0; n < NEARER; n++) {
    if (!obstacles.meet(from, from, reach, met, 1, 1)) return n > 0;
    let best = 0;
    let least = Infinity;
    for (let corner = 0; corner < CORNERS; corner++) {
      let sum = 0;
      for (let k = 0; k < 3; k++)
        sum += met[MET.normal + k]! * places[3 * triangles[f + corner]! + k]!;
      if (sum >= least) continue;
      least = sum;
      best = corner;
    }
    const share = 2 / (n + 3);
    for (let corner = 0; corner < CORNERS; corner++) corners[corner]! *= 1 - share;
    corners[best]! += share;
    for (let k = 0; k < 3; k++)
      from[k]! += share * (places[3 * triangles[f + best]! + k]! - from[k]!);
  }
  return obstacles.meet(from, from, reach, met, 1, 1);
}
