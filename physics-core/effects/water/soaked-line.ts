import { MOST_LIFT, THIN } from './tolerances.js';
import type { Volume } from './volume.js';
import { Braking } from './braking.js';
import type { WetLine } from './matter.js';

/** Of both ends of a link: what of it is below, as shares of its length. */
const shares = new Float64Array(2);
const lower = new Float64Array(2);
const middle = new Float64Array(3);
const speed = new Float64Array(3);
const along = new Float64Array(3);

/**
 * What water does to a line of links, each a cylinder: it is lifted by the weight of what it displaces, and braked across itself
 * (crossflow) as ½ ρ c d u² a metre. Along itself the water goes with it.
 */
export class SoakedLine {
  readonly braking = new Braking();
  displaced = 0;
  mass = 0;
  /** kg, of its own. */
  weighs = 0;
  depth = 0;
  speed = 0;
  deepest: Volume | undefined;

  /** Pushes it for so many seconds. False: it is in no water. */
  soak(of: WetLine, volumes: readonly Volume[], time: number): boolean {
    const { points } = of;
    const { braking } = this;
    braking.clear();
    this.displaced = this.mass = this.speed = this.weighs = 0;
    this.depth = -Infinity;
    this.deepest = undefined;
    for (const each of points.masses) this.weighs += each;
    let isWet = false;
    for (const volume of volumes) {
      const before = this.mass;
      if (!this.#press(of, volume)) continue;
      isWet = true;
      const { damping, flow } = volume.settings;
      const rate = (damping * (this.mass - before)) / this.weighs;
      braking.rate += rate;
      for (let k = 0; k < 3; k++) braking.flow[k]! += rate * flow[k]!;
    }
    if (!isWet) return false;
    for (let k = 0; k < 3; k++) if (braking.rate > 0) braking.flow[k]! /= braking.rate;
    const share = (MOST_LIFT * this.weighs) / this.mass;
    if (share < 1) for (let j = 0; j < braking.forces.length; j++) braking.forces[j]! *= share;
    braking.push(points, time);
    for (const volume of volumes) this.#resist(of, volume);
    braking.brake(points, time);
    return true;
  }

  #press(of: WetLine, volume: Volume): boolean {
    const { points, radius } = of;
    const { density } = volume.settings;
    const { gravity, up } = volume;
    if (!(density > 0)) return false;
    const down = Math.abs(gravity[0] * up[0] + gravity[1] * up[1] + gravity[2] * up[2]);
    let isWet = false;
    for (let i = 0; i + 1 < points.count; i++) {
      const thick = this.#dip(of, volume, i);
      if (thick < 0) continue;
      isWet = true;
      const volumeOfAll = Math.PI * radius * radius * of.lengths[i]!;
      for (let end = 0; end < 2; end++) {
        const displaced = volumeOfAll * shares[end]!;
        this.displaced += displaced;
        this.mass += density * displaced;
        for (let k = 0; k < 3; k++)
          this.braking.forces[3 * (i + end) + k]! -= density * displaced * gravity[k]!;
        if (shares[0]! + shares[1]! < 1)
          this.braking.stiffs[i + end]! += (density * down * volumeOfAll) / 2 / (thick || 1);
      }
    }
    if (isWet) this.#note(of, volume);
    return isWet;
  }

  /** What of a link is in a volume. Answers over what height it comes into it, metres; -1: it is not in it. */
  #dip({ points, radius }: WetLine, volume: Volume, i: number): number {
    const { places } = points;
    let square = 0;
    for (let k = 0; k < 3; k++) {
      middle[k] = (places[3 * i + k]! + places[3 * i + 3 + k]!) / 2;
      along[k] = places[3 * i + 3 + k]! - places[3 * i + k]!;
      square += along[k]! ** 2;
    }
    if (!volume.surrounds(middle)) return -1;
    const { up } = volume;
    const rises = along[0]! * up[0] + along[1]! * up[1] + along[2]! * up[2];
    const level = square > 0 ? Math.sqrt(Math.max(0, 1 - (rises * rises) / square)) : 1;
    const thick = 2 * radius * level;
    const head = volume.waterAbove(middle);
    shares.fill(0);
    addDip(head + rises / 2, head - rises / 2, thick, 1);
    const floor = volume.bottomAbove(middle);
    let bounded = -1;
    for (const { volume: other, sides } of volume.covers) {
      if (!volume.surrounds(middle, sides)) continue;
      const over = Math.min(head, other.above(middle));
      addDip(over + rises / 2, over - rises / 2, thick, -1);
      bounded = 0;
      break;
    }
    if (bounded < 0) addDip(floor + rises / 2, floor - rises / 2, thick, -1);
    return shares[0]! + shares[1]! > 0 ? thick + Math.abs(rises) : -1;
  }

  #note({ points, radius }: WetLine, volume: Volume): void {
    let deepest = -Infinity;
    let sinks = 0;
    for (let i = 0; i < points.count; i++) {
      for (let k = 0; k < 3; k++) {
        middle[k] = points.places[3 * i + k]!;
        sinks -= points.masses[i]! * volume.up[k]! * points.velocities[3 * i + k]!;
      }
      deepest = Math.max(deepest, volume.waterAbove(middle) + radius);
    }
    if (deepest <= this.depth) return;
    this.depth = deepest;
    this.deepest = volume;
    this.speed = sinks / this.weighs;
  }

  #resist(of: WetLine, volume: Volume): void {
    const { points, radius } = of;
    const { velocities } = points;
    const { before } = this.braking;
    const { density, drag, flow } = volume.settings;
    if (!(drag > 0) || !(density > 0)) return;
    for (let i = 0; i + 1 < points.count; i++) {
      if (this.#dip(of, volume, i) < 0) continue;
      let square = 0;
      let now = 0;
      let went = 0;
      for (let k = 0; k < 3; k++) {
        const j = 3 * i + k;
        speed[k] = (velocities[j]! + velocities[j + 3]!) / 2 - flow[k]!;
        square += along[k]! ** 2;
        now += speed[k]! * along[k]!;
        went += ((before[j]! + before[j + 3]!) / 2 - flow[k]!) * along[k]!;
      }
      let across = 0;
      for (let k = 0; k < 3; k++) {
        if (square > 0) across += (speed[k]! - (now * along[k]!) / square) ** 2;
        // As it went before: what holds it may keep it from going as it would by now.
        along[k] = square > 0 ? (went * along[k]!) / square : 0;
      }
      const press = density * drag * radius * of.lengths[i]! * Math.sqrt(across);
      for (let end = 0; end < 2; end++) this.#brake(i + end, press * shares[end]!, flow);
    }
  }

  /** Along the line the water goes as that does. */
  #brake(i: number, drag: number, flow: ArrayLike<number>): void {
    this.braking.drags[i]! += drag;
    this.braking.weights[i]! += drag;
    for (let k = 0; k < 3; k++) this.braking.flows[3 * i + k]! += drag * (flow[k]! + along[k]!);
  }
}

/**
 * Adds what of a link is below, by how deep its ends are, metres: of a cylinder that is so thick, as seen from above, its height
 * counts evenly.
 */
function addDip(a: number, b: number, thick: number, factor: number): void {
  if (!(thick > THIN)) return addLength(a, b, factor, shares);
  lower.fill(0);
  addDepth(a + thick / 2, b + thick / 2, factor / thick, lower);
  addDepth(a - thick / 2, b - thick / 2, -factor / thick, lower);
  shares[0]! += lower[0]!;
  shares[1]! += lower[1]!;
}

/** The mean over a link of how deep it is, times the share of each end. */
function addDepth(a: number, b: number, factor: number, out: Float64Array): void {
  if (!(a > 0) && !(b > 0)) return;
  if (a > 0 && b > 0) {
    out[0]! += (factor * (2 * a + b)) / 6;
    out[1]! += (factor * (2 * b + a)) / 6;
    return;
  }
  const deep = a > 0 ? 0 : 1;
  const other = 1 - deep;
  const p = Math.max(a, b);
  const t = p / Math.abs(a - b);
  out[deep]! += factor * p * (t / 2 - (t * t) / 6);
  out[other]! += (factor * p * t * t) / 6;
}

/** The same of what is below at all. */
function addLength(a: number, b: number, factor: number, out: Float64Array): void {
  if (!(a > 0) && !(b > 0)) return;
  const deep = a > 0 ? 0 : 1;
  const other = 1 - deep;
  const t = a > 0 && b > 0 ? 1 : Math.max(a, b) / Math.abs(a - b);
  out[deep]! += factor * (t - (t * t) / 2);
  out[other]! += (factor * t * t) / 2;
}
