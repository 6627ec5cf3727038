import { hypot } from '../../base/exact/index.js';
import type { Engine } from '../../engine/engine.js';
import { TimeOfImpact } from './time-of-impact.js';
import { OVER, type Impact } from './impact.js';
import { leaveOut } from '../contacts/contact-rows.js';

/** Hits that one blow may lead to. */
export const MOST_HITS = 200;

/** Hits nearer to each other count as simultaneous, seconds. */
const SAME_TIME = 1e-6;

/** One blow through touching bodies: hit after hit, the earliest first. */
export class Blow {
  readonly #chain: Impact[] = [];
  readonly timeOfImpact: TimeOfImpact;
  #dt = 0;
  #until = 0;
  /** Depth that resting contacts keep, metres. */
  slop = 0;
  /** Hits since whoever counts them set it to 0. */
  strikes = 0;

  constructor(engine: Engine) {
    this.timeOfImpact = new TimeOfImpact(engine);
  }

  /** Whether the hit comes, with its place at that time. */
  comes(hit: Impact, dt: number, until: number): boolean {
    if (!hit.comes(dt, until)) return false;
    if (hit.isLocated) return true;
    hit.noteLocated();
    return !this.timeOfImpact.locate(hit, dt) || hit.comes(dt, until);
  }

  /** The hit and all that it leads to in a step of `dt` seconds, before `until`. */
  handOn(first: Impact, dt: number, until: number): void {
    this.#dt = dt;
    this.#until = until;
    this.#chain.length = 0;
    this.#join(first);
    for (let i = 0; i < MOST_HITS; i++) {
      const hit = this.#earliest();
      if (!hit) break;
      this.#strike(hit);
      for (const next of hit.a.hits) this.#join(next);
      for (const next of hit.b.hits) this.#join(next);
    }
    for (const hit of this.#chain) {
      hit.chained = false;
      // Pressed together again, but too slowly to part once more.
      if (hit.impulse > 0 && hit.approach > 0) hit.handOver(this.slop);
    }
  }

  #join(hit: Impact): void {
    if (hit.chained) return;
    hit.chained = true;
    hit.point.refresh();
    this.#chain.push(hit);
  }

  /** Of those at the same time the hardest. */
  #earliest(): Impact | undefined {
    let first: Impact | undefined;
    for (const hit of this.#chain) {
      if (!this.comes(hit, this.#dt, this.#until)) continue;
      const sooner = first ? first.time - hit.time : Infinity;
      if (sooner > SAME_TIME || (sooner > -SAME_TIME && hit.speed > first!.speed)) first = hit;
    }
    return first;
  }

  #strike(hit: Impact): void {
    const { point, normal, time, speed, returned } = hit;
    const x = normal[0]!;
    const y = normal[1]!;
    const z = normal[2]!;
    const impulse = (speed + returned) / this.#inverseEffectiveMass(hit, x, y, z);
    if (!Number.isFinite(impulse)) return;
    this.#shiftGaps(hit, time);
    this.#push(hit, impulse, time);
    hit.impulse += impulse;
    hit.a.strikes++;
    hit.b.strikes++;
    this.strikes++;
    this.#rub(hit, impulse * point.friction, time);
    this.#shiftGaps(hit, -time);
    // What is left is no bounce any more, and the way back to the surface is made up for after the step.
    point.restitution = 0;
    if (returned > 0 && !hit.borne) leaveOut(point);
    else hit.handOver(this.slop);
    if (hit.a.isSpent) for (const each of hit.a.hits) each.handOver(this.slop);
    if (hit.b.isSpent) for (const each of hit.b.hits) each.handOver(this.slop);
    hit.writePlace();
  }

  /** Before and after a strike: gaps are those of paths led back to the start of the step with the speeds of now. */
  #shiftGaps({ a, b }: Impact, time: number): void {
    for (const hit of a.hits) hit.gap -= time * hit.approach;
    for (const hit of b.hits) if (!a.hits.includes(hit)) hit.gap -= time * hit.approach;
  }

  /** Coulomb's friction of the hit: against the sliding, and no more than ends it. */
  #rub(hit: Impact, most: number, time: number): void {
    const x = hit.normal[0]!;
    const y = hit.normal[1]!;
    const z = hit.normal[2]!;
    const out = hit.speedAlong(x, y, z);
    const u = hit.speedAlong(1, 0, 0) - out * x;
    const v = hit.speedAlong(0, 1, 0) - out * y;
    const w = hit.speedAlong(0, 0, 1) - out * z;
    const sliding = hypot(u, v, w);
    if (sliding < OVER) return;
    const inverseEffectiveMass = this.#inverseEffectiveMass(
      hit,
      u / sliding,
      v / sliding,
      w / sliding,
    );
    this.#push(hit, -Math.min(most, sliding / inverseEffectiveMass), time);
  }

  /** How far both give way along a direction, 1/kg. */
  #inverseEffectiveMass(hit: Impact, x: number, y: number, z: number): number {
    return (
      hit.a.known().inverseEffectiveMass(hit.armA, x, y, z) +
      hit.b.known().inverseEffectiveMass(hit.armB, x, y, z)
    );
  }

  #push({ a, b }: Impact, impulse: number, time: number): void {
    if (a.movable) a.push(impulse, time);
    if (b.movable) b.push(-impulse, time);
  }
}
