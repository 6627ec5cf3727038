import { dot3 } from '../../base/flat-math.js';
import { grown, grownInt } from '../../base/grown.js';
import type { Material } from '../../solver/deformables/material.js';
import { MET, METS, type Obstacles } from '../particles/collide/obstacles.js';
import type { Deformable } from './deformable.js';
import type { Guests } from './guests.js';
import type { Samples } from './samples.js';
import { AHEAD, FLAT, RETURN, SWEEPS, TURNS } from './tolerances.js';

const met = new Float64Array(METS);
const from = new Float64Array(3);
const to = new Float64Array(3);
const now = new Float64Array(3);
const was = new Float64Array(3);
/** Of a point of a body: since the step began, and in this part. */
const way = new Float64Array(6);
const push = new Float64Array(3);
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
  /** In this part of a step, kg m. */
  #pressed = new Float64Array(0);
  #rubbed = new Float64Array(0);
  /** Of each point of the surface, its touch; -1: it has none. */
  #touchOf = new Int32Array(0);

  /** Bodies that it may touch, each as often as it does. */
  get slots(): Int32Array {
    return this.#slots.subarray(0, this.count);
  }

  /** Who may touch what in a step of `dt` seconds that begins. */
  look(deformable: Deformable, obstacles: Obstacles, guests: Guests, dt: number): void {
    this.count = 0;
    if (!deformable.settings.touches) return;
    const { count } = deformable.material.surface;
    if (this.#touchOf.length < count) this.#touchOf = new Int32Array(count);
    this.#touchOf.fill(-1);
    if (!deformable.settings.touches) return;
    this.#lookAtPoints(deformable, obstacles, guests, dt);
    this.#lookAtSamples(deformable, obstacles, guests, dt);
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
      const margin = (radius > 0 ? AHEAD * radius : TURNS) + Math.sqrt(square);
      if (!meets(obstacles, radius, margin)) continue;
      if (within.get(i) === met[MET.body]!) continue;
      guests.add(met[MET.body]!, dt);
      this.#touchOf[i] = this.count;
      this.#note(from, radius, 1);
      this.#points[CORNERS * (this.count - 1)] = i;
      this.#weights[CORNERS * (this.count - 1)] = 1;
    }
  }

  /** Edges and corners of bodies come between points: where these do not all touch the same, and lie flat on it. */
  #lookAtSamples(
    { material: { surface }, settings: { radius }, samples, within }: Deformable,
    obstacles: Obstacles,
    guests: Guests,
    dt: number,
  ): void {
    const { places } = surface;
    const { count, points, weights } = samples;
    for (let n = 0; n < count; n++) {
      if (this.#liesFlat(points, weights, CORNERS * n)) continue;
      for (let k = 0; k < 3; k++) {
        from[k] = 0;
        for (let m = CORNERS * n; m < CORNERS * (n + 1); m++)
          from[k]! += weights[m]! * places[3 * points[m]! + k]!;
      }
      const reach = (1 + AHEAD) * radius;
      if (!obstacles.isNear(from, from, reach)) continue;
      if (!obstacles.meet(from, from, reach, met, 1, 1)) continue;
      if (isWithin(within, met[MET.body]!, samples, CORNERS * n)) continue;
      guests.add(met[MET.body]!, dt);
      this.#note(from, radius, CORNERS);
      for (let m = 0; m < CORNERS; m++) {
        this.#points[CORNERS * (this.count - 1) + m] = points[CORNERS * n + m]!;
        this.#weights[CORNERS * (this.count - 1) + m] = weights[CORNERS * n + m]!;
      }
    }
  }

  #liesFlat(points: Int32Array, weights: Float64Array, first: number): boolean {
    let a = -1;
    for (let n = first; n < first + CORNERS; n++) {
      if (weights[n] === 0) continue;
      const b = this.#touchOf[points[n]!]!;
      if (b < 0) return false;
      if (a >= 0 && this.#slots[a] !== this.#slots[b]) return false;
      if (a >= 0 && dot3(this.#normals, 3 * a, this.#normals, 3 * b) < FLAT) return false;
      a = b;
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
    this.#pressed = grown(this.#pressed, room);
    this.#rubbed = grown(this.#rubbed, 3 * room);
  }

  /**
   * Whoever is too near is taken away, in a part of `time` seconds that ends `since` seconds after the step began. Where more
   * points touch than carry them, each takes back what the others have done of its push: all that is too much would drive it.
   */
  hold(deformable: Deformable, guests: Guests, time: number, since: number): void {
    const sweeps = deformable.material.surface.width > 1 ? SWEEPS : 1;
    this.#pressed.fill(0, 0, this.count);
    this.#rubbed.fill(0, 0, 3 * this.count);
    for (let sweep = 0; sweep < sweeps; sweep++) this.#sweep(deformable, guests, time, since);
  }

  #sweep(
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
      // What begins inside comes out in time: that gives it no speed, and pushes nobody.
      const isIn = this.#depths[c]! + RETURN * since < 0;
      gap -= Math.min(0, this.#depths[c]! + RETURN * since);
      const pressed = this.#pressed[c]!;
      if (!(gap < 0 || pressed > 0) || !(gives > 0)) continue;
      const out = isIn && gap < 0 ? Math.min(-gap, RETURN * time) : 0;
      if (out > 0) this.#comeOut(material, c, out / gives);
      const more = (-gap - out) / (gives + guests.gives(slot, this.#bases, 3 * c, along));
      const press = Math.max(-pressed, more);
      this.#pressed[c]! += press;
      for (let k = 0; k < 3; k++) push[k] = press * along[k]!;
      this.#rub(slot, c, friction * this.#pressed[c]!, gives, guests);
      this.#push(material.masses.places, material, c);
      for (let k = 0; k < 3; k++) push[k] = -push[k]!;
      guests.push(slot, this.#bases, 3 * c, push, time);
    }
  }

  /** Where it began the part goes along: what is taken there is no faster for it. */
  #comeOut(material: Material, c: number, far: number): void {
    for (let k = 0; k < 3; k++) push[k] = far * along[k]!;
    this.#push(material.masses.places, material, c);
    this.#push(material.masses.before, material, c);
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

  #push(places: Float64Array, { surface, masses }: Material, c: number): void {
    const { width, carriers, shares } = surface;
    const { inverse } = masses;
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
    if (square > 0) {
      const far = Math.sqrt(square);
      for (let k = 0; k < 3; k++) way[k] = now[k]! / far;
      const all = gives + guests.gives(slot, this.#bases, 3 * c, way);
      for (let k = 0; k < 3; k++) now[k]! /= all;
    }
    square = 0;
    for (let k = 0; k < 3; k++) {
      now[k] = this.#rubbed[3 * c + k]! - now[k]!;
      square += now[k]! * now[k]!;
    }
    const share = square > most * most ? most / Math.sqrt(square) : 1;
    for (let k = 0; k < 3; k++) {
      push[k]! += share * now[k]! - this.#rubbed[3 * c + k]!;
      this.#rubbed[3 * c + k] = share * now[k]!;
    }
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

/** What is beside a point that is tied within a body does not touch that, either. */
function isWithin(
  within: ReadonlyMap<number, number>,
  slot: number,
  { points, weights }: Samples,
  first: number,
): boolean {
  if (within.size === 0) return false;
  for (let n = first; n < first + CORNERS; n++)
    if (weights[n]! > 0 && within.get(points[n]!) === slot) return true;
  return false;
}
