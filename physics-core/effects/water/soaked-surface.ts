import { grown } from '../../base/grown.js';
import { MOST_LIFT, THIN } from './tolerances.js';
import type { Cover, Volume } from './volume.js';
import { Braking } from './braking.js';
import { DIP, DIPS } from './dip.js';
import { Heads } from './heads.js';
import { HullDrag } from './hull-drag.js';
import { SolidLift } from './solid-lift.js';
import type { WetSurface } from './matter.js';
import { apart, measure, middle, normal, sizeOf } from './triangle.js';

const dip = new Float64Array(DIPS);
const lower = new Float64Array(DIPS);
/** Across its surface the weight of water, m/s²: what is left of it where that is tilted. */
const across = new Float64Array(3);

/**
 * What water does to a surface of triangles, as it is deformed then.
 *
 * What encloses something is lifted by the weight of what it displaces (Archimedes): a skin by what presses on it from place to
 * place, and a solid throughout. What encloses nothing is lifted by its own thickness. Each triangle is braked as a body's skin
 * is, by its front and its back.
 */
export class SoakedSurface {
  readonly braking = new Braking();
  readonly #heads = new Heads();
  readonly #lift = new SolidLift();
  readonly #drag = new HullDrag();
  /** Of the points of its hull: newtons. */
  #forces = new Float64Array(0);
  /** Of each what it has of the areas around it, m². */
  #normals = new Float64Array(0);
  /** N/m: how much more each is lifted as it sinks. */
  #stiffs = new Float64Array(0);
  /** By volume: what is wet of each triangle, at each corner, m². */
  readonly #wet: Float64Array[] = [];
  /** m³ that it displaces, and what that weighs, kg. */
  displaced = 0;
  mass = 0;
  /** kg, of its own. */
  weighs = 0;
  /** Where it is deepest: how far its lowest point is below the surface, metres, how fast it sinks, m/s. */
  depth = 0;
  speed = 0;
  deepest: Volume | undefined;

  /** Pushes it for so many seconds. False: it is in no water. */
  soak(of: WetSurface, volumes: readonly Volume[], time: number): boolean {
    const { masses, hull } = of;
    hull.follow(masses);
    this.#clear(of, volumes.length);
    let isWet = false;
    let rate = 0;
    const whole = (this.weighs = massOf(masses.masses));
    for (let v = 0; v < volumes.length; v++) {
      const volume = volumes[v]!;
      const before = this.mass;
      if (!this.#press(of, volume, this.#wet[v]!)) continue;
      isWet = true;
      const { damping, flow } = volume.settings;
      rate += (damping * (this.mass - before)) / whole;
      for (let k = 0; k < 3; k++)
        this.braking.flow[k]! += (damping * (this.mass - before) * flow[k]!) / whole;
    }
    if (!isWet) return false;
    this.#bound(MOST_LIFT * whole);
    const { braking } = this;
    this.#spreadForces(of);
    braking.push(masses, time);
    this.#drag.look(of);
    for (let v = 0; v < volumes.length; v++) this.#drag.resist(of, volumes[v]!, this.#wet[v]!);
    this.#drag.spread(of, braking);
    braking.rate = Math.max(0, rate);
    for (let k = 0; k < 3; k++) if (rate > 0) braking.flow[k]! /= rate;
    braking.brake(masses, time);
    return true;
  }

  #clear({ hull }: WetSurface, volumes: number): void {
    const { count, triangles } = hull;
    if (this.#stiffs.length < count) {
      this.#forces = grown(this.#forces, 3 * count);
      this.#normals = grown(this.#normals, 3 * count);
      this.#stiffs = grown(this.#stiffs, count);
    }
    for (let v = 0; v < volumes; v++) {
      const wet = this.#wet[v];
      if (!wet || wet.length < triangles.length) this.#wet[v] = new Float64Array(triangles.length);
      else wet.fill(0);
    }
    this.#forces.fill(0);
    this.#stiffs.fill(0);
    this.#drag.clear(count);
    this.braking.clear();
    this.displaced = this.mass = this.speed = 0;
    this.depth = -Infinity;
    this.deepest = undefined;
  }

  /** No more than that may lift it, kg. */
  #bound(most: number): void {
    if (!(this.mass > most)) return;
    const share = most / this.mass;
    for (const forces of [this.#forces, this.braking.forces])
      for (let j = 0; j < forces.length; j++) forces[j]! *= share;
    this.mass *= share;
  }

  // ---- what lifts it ----------------------------------------------------------------------------------------------------

  /** False: it is not in that one. */
  #press(of: WetSurface, volume: Volume, wet: Float64Array): boolean {
    const { hull, side, thickness } = of;
    const { places, count } = hull;
    const heads = this.#heads;
    const { density } = volume.settings;
    if (!(density > 0) || !heads.measure(volume, places, count, side === 0 ? thickness : 0))
      return false;
    if (side !== 0 && !this.#bounds(hull, volume)) return false;
    const isWet = side === 0 ? this.#pressSheet(of, volume, wet) : this.#pressHull(of, volume, wet);
    if (isWet) this.#note(of, volume);
    return isWet;
  }

  /**
   * What it displaces, by the weight of the water above each place. Its skin is pressed by that where it is hollow, less the
   * mean of it: the gas in it is given by what it has above the outside. What is solid is lifted throughout.
   */
  #pressHull(of: WetSurface, volume: Volume, wet: Float64Array): boolean {
    const { side, solid } = of;
    const { places, triangles } = of.hull;
    const { up, settings } = volume;
    const { density } = settings;
    const down = this.#tilt(volume);
    const press = solid === undefined ? side * density : 0;
    const lift = this.#lift;
    const before = this.displaced;
    let all = 0;
    let heads = 0;
    let isWet = false;
    lift.clear();
    this.#normals.fill(0);
    for (let n = 0; n + 2 < triangles.length; n += 3) {
      const i = triangles[n]!;
      const j = triangles[n + 1]!;
      const m = triangles[n + 2]!;
      measure(places, i, j, m);
      const rises = up[0] * normal[0]! + up[1] * normal[1]! + up[2] * normal[2]!;
      const area = sizeOf(normal);
      this.#heads.dip(i, j, m, 0, dip);
      all += area;
      for (let c = 0; c < 3; c++) {
        const point = triangles[n + c]!;
        const head = dip[DIP.depth + c]!;
        const share = dip[DIP.share + c]!;
        if (share > 0) isWet = true;
        heads += area * head;
        wet[n + c] = area * share;
        const displaced = -side * rises * head;
        this.displaced += displaced;
        lift.displace(volume, places, point, displaced);
        if (press === 0) continue;
        this.#stiffs[point]! += density * Math.abs(down * rises) * share;
        for (let k = 0; k < 3; k++) {
          this.#normals[3 * point + k]! += normal[k]! / 3;
          this.#forces[3 * point + k]! += press * head * (across[k]! * rises - down * normal[k]!);
        }
      }
    }
    if (press !== 0) this.#takeMean(of, volume, down, all > 0 ? (press * heads) / all : 0);
    else if (isWet) this.displaced = before + lift.spread(of, volume, this.#heads, this.braking);
    this.mass += density * (this.displaced - before);
    return isWet;
  }

  /** Even pressure moves nothing. */
  #takeMean({ hull }: WetSurface, { up }: Volume, down: number, mean: number): void {
    const normals = this.#normals;
    for (let j = 0; j < 3 * hull.count; j += 3) {
      const rises = up[0] * normals[j]! + up[1] * normals[j + 1]! + up[2] * normals[j + 2]!;
      for (let k = 0; k < 3; k++)
        this.#forces[j + k]! -= mean * (across[k]! * rises - down * normals[j + k]!);
    }
  }

  /** By how thick it is. */
  #pressSheet({ hull, thickness }: WetSurface, volume: Volume, wet: Float64Array): boolean {
    const { places, triangles } = hull;
    const { up, gravity, settings } = volume;
    const { density } = settings;
    const down = Math.abs(this.#tilt(volume));
    const heads = this.#heads;
    let isWet = false;
    for (let n = 0; n + 2 < triangles.length; n += 3) {
      const i = triangles[n]!;
      const j = triangles[n + 1]!;
      const m = triangles[n + 2]!;
      measure(places, i, j, m);
      if (!this.#standsIn(hull, volume, i, j, m)) continue;
      const area = sizeOf(normal);
      const rises = Math.abs(up[0] * normal[0]! + up[1] * normal[1]! + up[2] * normal[2]!);
      this.#dipSheet(i, j, m, area > 0 ? (thickness * rises) / area : 0);
      asItWeighs(places, i, j, m);
      const stiff = (density * down * heads.rises(i, j, m, area * thickness)) / 3;
      for (let c = 0; c < 3; c++) {
        const point = triangles[n + c]!;
        const share = area * dip[DIP.share + c]!;
        if (share > 0) isWet = true;
        wet[n + c] = share;
        this.displaced += thickness * share;
        this.mass += density * thickness * share;
        this.#stiffs[point]! += stiff;
        for (let k = 0; k < 3; k++)
          this.#forces[3 * point + k]! -= density * thickness * share * gravity[k]!;
      }
    }
    return isWet;
  }

  /** How much of the weight of water acts against its surface, m/s²; the rest goes into `across`. */
  #tilt({ gravity, up }: Volume): number {
    const down = -(gravity[0] * up[0] + gravity[1] * up[1] + gravity[2] * up[2]);
    for (let k = 0; k < 3; k++) across[k] = gravity[k]! + down * up[k]!;
    return down;
  }

  /** Share of its width that is between the sides of a volume, and between those of what is there instead. */
  #bounds({ places, count }: WetSurface['hull'], volume: Volume): boolean {
    const heads = this.#heads;
    heads.share = volume.shareOf(places, count);
    heads.covered = 0;
    if (!(heads.share > 0)) return false;
    let most: Cover | undefined;
    for (const cover of volume.covers) {
      const share = volume.shareOf(places, count, cover.sides);
      if (!(share > heads.covered)) continue;
      heads.covered = share;
      most = cover;
    }
    if (most) for (let i = 0; i < count; i++) heads.coverWith(most, places, i);
    return true;
  }

  /** Whether a triangle by itself is between the sides of a volume: its middle. */
  #standsIn(
    { places }: WetSurface['hull'],
    volume: Volume,
    i: number,
    j: number,
    m: number,
  ): boolean {
    const heads = this.#heads;
    heads.share = 1;
    heads.covered = 0;
    if (!volume.surrounds(middle)) return false;
    for (const cover of volume.covers) {
      if (!volume.surrounds(middle, cover.sides)) continue;
      heads.covered = 1;
      heads.coverWith(cover, places, i);
      heads.coverWith(cover, places, j);
      heads.coverWith(cover, places, m);
      break;
    }
    return true;
  }

  /** What of a sheet is below, `thick` metres from its upper side to its lower one. */
  #dipSheet(i: number, j: number, m: number, thick: number): void {
    const heads = this.#heads;
    heads.thick = thick;
    if (!(thick > THIN)) return heads.dip(i, j, m, 0, dip);
    heads.dip(i, j, m, thick / 2, dip);
    heads.dip(i, j, m, -thick / 2, lower);
    for (let c = 0; c < 3; c++) dip[DIP.share + c] = (dip[c]! - lower[c]!) / thick;
  }

  #note({ masses, side, thickness }: WetSurface, volume: Volume): void {
    const deepest = this.#heads.deepest + (side === 0 ? thickness / 2 : 0);
    if (deepest <= this.depth) return;
    const { up } = volume;
    let whole = 0;
    let sinks = 0;
    for (let i = 0; i < masses.count; i++) {
      whole += masses.masses[i]!;
      for (let k = 0; k < 3; k++)
        sinks -= masses.masses[i]! * up[k]! * masses.velocities[3 * i + k]!;
    }
    this.deepest = volume;
    this.depth = deepest;
    this.speed = sinks / whole;
  }

  // ---- who carries it -----------------------------------------------------------------------------------------------------

  #spreadForces({ hull }: WetSurface): void {
    const { width, carriers, shares, count } = hull;
    const from = this.#forces;
    const { forces, stiffs } = this.braking;
    for (let i = 0, n = 0; i < count; i++) {
      const x = from[3 * i]!;
      const y = from[3 * i + 1]!;
      const z = from[3 * i + 2]!;
      const stiff = this.#stiffs[i]!;
      if (x === 0 && y === 0 && z === 0 && stiff === 0) n += width;
      else
        for (const end = n + width; n < end; n++) {
          const share = shares[n]!;
          const j = 3 * carriers[n]!;
          forces[j]! += share * x;
          forces[j + 1]! += share * y;
          forces[j + 2]! += share * z;
          stiffs[carriers[n]!]! += share * stiff;
        }
    }
  }
}

/** What is wet of a triangle goes to its corners as its weight does, so that they sink together: each has what is nearest to it. */
function asItWeighs(places: Float64Array, i: number, j: number, m: number): void {
  const a = apart(places, j, m);
  const b = apart(places, m, i);
  const c = apart(places, i, j);
  const sum = a + b + c;
  // Half of a blunt one is nearest to its blunt corner (mixed Voronoi areas, as cloth weighs).
  const isBlunt = 2 * Math.max(a, b, c) >= sum;
  const all = a * (sum - 2 * a) + b * (sum - 2 * b) + c * (sum - 2 * c);
  let before = 0;
  let after = 0;
  for (let k = 0; k < 3; k++) {
    const own = k === 0 ? a : k === 1 ? b : c;
    const blunt = 2 * own >= sum ? 2 : 1;
    before += dip[DIP.share + k]!;
    after += dip[DIP.share + k]! *= isBlunt ? blunt : all - own * (sum - 2 * own);
  }
  for (let k = 0; k < 3; k++) dip[DIP.share + k]! *= after > 0 ? before / after : 0;
}

function massOf(masses: Float64Array): number {
  let whole = 0;
  for (const each of masses) whole += each;
  return whole;
}
