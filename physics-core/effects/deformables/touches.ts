import { grown, grownInt } from '../../base/grown.js';
import { MET, METS, type Obstacles } from '../particles/collide/obstacles.js';
import type { Deformable } from './deformable.js';
import type { Guests } from './guests.js';
import { AHEAD, RETURN } from './tolerances.js';

const met = new Float64Array(METS);
const from = new Float64Array(3);
const to = new Float64Array(3);
const now = new Float64Array(3);
const was = new Float64Array(3);
/** Of a point of a body: since the step began, and in this part. */
const way = new Float64Array(6);
const push = new Float64Array(3);
const along = new Float64Array(3);

/** Points of one surface, as many as `room`, and what they touch in a step. */
export class Touches {
  count = 0;
  /** Which point of the surface; the slot of the body. */
  #points = new Int32Array(0);
  #slots = new Int32Array(0);
  /** Outward normals, and points of the surfaces of bodies when the step begins. */
  #normals = new Float64Array(0);
  #bases = new Float64Array(0);
  /** How deep each was when the step began, metres, 0 or less. */
  #depths = new Float64Array(0);

  /** Who may touch what in a step of `dt` seconds that begins. */
  look(
    { material, settings: { radius, touches }, within }: Deformable,
    obstacles: Obstacles,
    guests: Guests,
    dt: number,
  ): void {
    this.count = 0;
    if (!touches) return;
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
      this.#note(i, radius);
    }
  }

  #note(i: number, radius: number): void {
    this.#grow();
    const c = this.count++;
    this.#points[c] = i;
    this.#slots[c] = met[MET.body]!;
    let gap = -radius;
    for (let k = 0; k < 3; k++) {
      this.#normals[3 * c + k] = met[MET.normal + k]!;
      this.#bases[3 * c + k] = met[MET.point + k]!;
      gap += met[MET.normal + k]! * (from[k]! - met[MET.point + k]!);
    }
    this.#depths[c] = Math.min(0, gap);
  }

  #grow(): void {
    if (this.count < this.#points.length) return;
    const room = 2 * this.count + 16;
    this.#points = grownInt(this.#points, room);
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
    const { surface, masses } = material;
    const { width, carriers, shares } = surface;
    const { places, before, inverse } = masses;
    const normals = this.#normals;
    const bases = this.#bases;
    for (let c = 0; c < this.count; c++) {
      const first = width * this.#points[c]!;
      now.fill(0);
      was.fill(0);
      let gives = 0;
      for (let n = first; n < first + width; n++) {
        const j = 3 * carriers[n]!;
        const share = shares[n]!;
        gives += share * share * inverse[carriers[n]!]!;
        for (let k = 0; k < 3; k++) {
          now[k]! += share * places[j + k]!;
          was[k]! += share * before[j + k]!;
        }
      }
      const slot = this.#slots[c]!;
      guests.wayOf(slot, bases, 3 * c, way);
      let gap = -radius;
      for (let k = 0; k < 3; k++)
        gap += normals[3 * c + k]! * (now[k]! - bases[3 * c + k]! - way[k]!);
      // What begins inside comes out in time.
      gap -= Math.min(0, this.#depths[c]! + RETURN * since);
      if (!(gap < 0)) continue;
      for (let k = 0; k < 3; k++) along[k] = normals[3 * c + k]!;
      const press = -gap / (gives + guests.gives(slot, bases, 3 * c, along));
      for (let k = 0; k < 3; k++) push[k] = press * along[k]!;
      this.#rub(slot, c, friction * press, gives, guests);
      for (let n = first; n < first + width; n++) {
        const j = 3 * carriers[n]!;
        const share = shares[n]! * inverse[carriers[n]!]!;
        for (let k = 0; k < 3; k++) places[j + k]! += share * push[k]!;
      }
      for (let k = 0; k < 3; k++) push[k] = -push[k]!;
      guests.push(slot, bases, 3 * c, push, time);
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
