import { grown } from '../../base/grown.js';
import type { Points } from './matter.js';

const way = new Float64Array(3);
const turned = new Float64Array(3);

/**
 * What water does to points of mass in a part of a step, and how they go on with it.
 *
 * Each is braked by its drag D, which belongs to how fast it is, without any of its neighbours: (M + D dt) u' = M u. So no
 * step turns a motion round, and what comes to its terminal speed has that exactly. D is that of the speed at the start, as for
 * bodies; where it would be faster without drag, as what is light is, it is that of the speed that drag itself leaves.
 */
export class Braking {
  /** Newtons, x, y, z of each. */
  forces = new Float64Array(0);
  /** kg/s, as of how fast each is now; the same by lift, as a vector; and where the water goes there, with what weight. */
  drags = new Float64Array(0);
  lifts = new Float64Array(0);
  flows = new Float64Array(0);
  weights = new Float64Array(0);
  /** N/m by which each is lifted more as it sinks. */
  stiffs = new Float64Array(0);
  /** 1/s, of all of them. */
  rate = 0;
  /** Of the water of all, m/s. */
  readonly flow = new Float64Array(3);
  /** m/s, before anything acted on them in this part. */
  before = new Float64Array(0);
  #inverse = new Float64Array(0);
  #heavier = false;

  /** A part begins. */
  begin({ velocities, count }: Points): void {
    if (this.drags.length < count) this.#grow(count);
    this.before.set(velocities);
  }

  #grow(count: number): void {
    for (const each of ['forces', 'lifts', 'flows'] as const)
      this[each] = grown(this[each], 3 * count);
    this.before = grown(this.before, 3 * count);
    this.drags = grown(this.drags, count);
    this.weights = grown(this.weights, count);
    this.stiffs = grown(this.stiffs, count);
    this.#inverse = grown(this.#inverse, count);
  }

  clear(): void {
    for (const each of [this.forces, this.drags, this.lifts, this.flows, this.weights, this.stiffs])
      each.fill(0);
    this.flow.fill(0);
    this.rate = 0;
  }

  /** What lifts them acts for `time` seconds. */
  push({ velocities, inverse, count }: Points, time: number): void {
    for (let i = 0; i < count; i++)
      for (let j = 3 * i; j < 3 * i + 3; j++)
        velocities[j]! += time * inverse[i]! * this.forces[j]!;
  }

  /** What brakes them does, and until `dry` they are as much heavier for what holds them. */
  brake({ velocities, inverse, count }: Points, time: number): void {
    for (let i = 0; i < count; i++) this.#inverse[i] = inverse[i]!;
    this.#heavier = true;
    for (let i = 0; i < count; i++) {
      const drag = Math.max(0, this.drags[i]!);
      const weight = this.weights[i]!;
      if (!(inverse[i]! > 0)) continue;
      this.#steady(velocities, inverse, i, time);
      if (!(weight + this.rate > 0)) continue;
      let now = 0;
      let before = 0;
      for (let k = 0; k < 3; k++) {
        const j = 3 * i + k;
        this.flows[j] = weight > 0 ? this.flows[j]! / weight : this.flow[k]!;
        way[k] = velocities[j]! - this.flows[j]!;
        now += way[k]! ** 2;
        before += (this.before[j]! - this.flows[j]!) ** 2;
      }
      const slowed = 1 + time * this.rate;
      const most = time * inverse[i]! * drag;
      const felt = Math.min(1, Math.max(Math.sqrt(before / now) || 0, leaves(slowed, most)));
      const heavier = slowed + felt * most;
      this.#turn(velocities, i, heavier, felt * time * inverse[i]!);
      inverse[i]! /= heavier;
    }
  }

  /** A surface that is too stiff for such a time is as stiff as it can show: as much heavier is what swings on it (β = ¼). */
  #steady(velocities: Float64Array, inverse: Float64Array, i: number, time: number): void {
    const heavier = 1 + (time * time * Math.max(0, this.stiffs[i]!) * inverse[i]!) / 4;
    if (heavier === 1) return;
    for (let j = 3 * i; j < 3 * i + 3; j++)
      velocities[j] = this.before[j]! + (velocities[j]! - this.before[j]!) / heavier;
    inverse[i]! /= heavier;
  }

  /** Lift turns it as it is braked: (a + b ×) u' = u. */
  #turn(velocities: Float64Array, i: number, a: number, share: number): void {
    const x = share * this.lifts[3 * i]!;
    const y = share * this.lifts[3 * i + 1]!;
    const z = share * this.lifts[3 * i + 2]!;
    const along = (x * way[0]! + y * way[1]! + z * way[2]!) / a;
    const whole = a * a + x * x + y * y + z * z;
    turned[0] = a * way[0]! + along * x - (y * way[2]! - z * way[1]!);
    turned[1] = a * way[1]! + along * y - (z * way[0]! - x * way[2]!);
    turned[2] = a * way[2]! + along * z - (x * way[1]! - y * way[0]!);
    for (let k = 0; k < 3; k++) velocities[3 * i + k] = this.flows[3 * i + k]! + turned[k]! / whole;
  }

  /** The part is over. */
  dry({ inverse, count }: Points): void {
    if (!this.#heavier) return;
    this.#heavier = false;
    for (let i = 0; i < count; i++) inverse[i] = this.#inverse[i]!;
  }
}

/** The share of its speed that is left at the end, where all of it would be braked by so much: w u + r u² = 1. */
const leaves = (slowed: number, most: number): number =>
  2 / (slowed + Math.sqrt(slowed * slowed + 4 * most));
