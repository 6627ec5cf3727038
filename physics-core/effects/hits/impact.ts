import { ContactPoint } from '../../engine/contact-point.js';
import { originOf, speedAt } from '../../engine/body-heap.js';
import type { Ammo } from '../../engine/ammo.js';
import type { Engine } from '../../engine/engine.js';
import type { HitShape } from './hit-shape.js';
import type { StruckBody } from './struck-body.js';

/** Below this approach a hit is over: what bounces less and less would go on for ever, m/s. */
export const OVER = 1e-3;

/** A point where something round touches: whether it hits in this step, when, and how hard. */
export class Impact {
  readonly #ammo: Ammo;
  readonly point: ContactPoint;
  a!: StruckBody;
  b!: StruckBody;
  /** Of what touches, where a ball touches something that is known in closed form. */
  shapeA: HitShape | undefined;
  shapeB: HitShape | undefined;
  /** From B into A, and from both centres of mass to where they touch: as Bullet found it, then at the hit's own time. */
  readonly normal = new Float64Array(3);
  readonly armA = new Float64Array(3);
  readonly armB = new Float64Array(3);
  /** Hits of both bodies when it was located last. */
  #located = -1;
  bounce = 0;
  /** Approach speed that bounces at least, m/s. */
  least = 0;
  /** Metres at the start of the step; hits before this one move it to where its path leads back to. */
  gap = 0;
  /** Of the approach, m/s². */
  #pull = 0;
  /** The same, or where something bears one of them that of either alone: below what it gives in a step, all rests. */
  #rest = 0;
  /** Of what velocities in joints' middle of the step are ahead of those at its start, m/s. */
  #lead = 0;
  /** As Bullet found it, metres, negative. */
  #depth = 0;
  /** N s that went through it in this step. */
  impulse = 0;
  /** Part of the blow that is being worked out. */
  chained = false;
  /** Seconds after the start of the step, below 0 where it was missed in the step before. */
  time = 0;
  /** Approach at that time, m/s. */
  speed = 0;

  constructor({ ammo }: Engine) {
    this.#ammo = ammo;
    this.point = new ContactPoint(ammo);
  }

  /** Whether one of both lies on something, as in a heap. */
  get borne(): boolean {
    return this.a.borne || this.b.borne;
  }

  get approach(): number {
    return this.#lead - this.speedAlong(this.normal[0]!, this.normal[1]!, this.normal[2]!);
  }

  /** Of A against B where they touch, m/s. */
  speedAlong(x: number, y: number, z: number): number {
    const { a, b, armA, armB } = this;
    return (
      speedAt(this.#ammo, a.body.pointer, armA, x, y, z) -
      speedAt(this.#ammo, b.body.pointer, armB, x, y, z)
    );
  }

  /** As Bullet found it. */
  begin(distance: number, dt: number): void {
    const { point, a, b } = this;
    for (let i = 0; i < 3; i++) {
      this.normal[i] = point.normal(i);
      this.armA[i] = point.position(i) - originOf(this.#ammo, a.body.pointer, i);
      this.armB[i] = point.position(i) - originOf(this.#ammo, b.body.pointer, i);
    }
    this.gap = distance + a.lateAt(this.armA, this.normal) - b.lateAt(this.armB, this.normal);
    this.#depth = point.solverDistance;
    this.#located = -1;
    this.impulse = 0;
    this.chained = false;
    this.#weigh(dt);
  }

  /** So far apart at the start of the step. */
  measured(gap: number, dt: number): void {
    this.gap = gap;
    this.#weigh(dt);
  }

  /** It was located at this time: the plane in which they touch then. */
  touchAt(time: number, dt: number): void {
    this.#weigh(dt);
    this.gap = (this.approach + (this.#pull * time) / 2) * time;
  }

  /** Whether its time and place are those of the velocities of now. */
  get isLocated(): boolean {
    return this.#located === this.a.strikes + this.b.strikes;
  }

  noteLocated(): void {
    this.#located = this.a.strikes + this.b.strikes;
  }

  /** For whoever reads it: here they touched. */
  writePlace(): void {
    const { point, b } = this;
    for (let i = 0; i < 3; i++) {
      const place = originOf(this.#ammo, b.body.pointer, i) + this.armB[i]!;
      point.setNormal(i, this.normal[i]!);
      point.setPosition(i, place);
      point.setPositionOnA(i, place);
    }
  }

  /** Whether one of the bodies, which lies on something else, does not fall away from the other. */
  stays(link: StruckBody): boolean {
    return link.carried && this.#pullOf(link, link === this.a ? -1 : 1) < 0;
  }

  #weigh(dt: number): void {
    this.#pull = this.#lead = this.#rest = 0;
    this.#add(this.a, -1, dt);
    this.#add(this.b, 1, dt);
    if (!this.borne) this.#rest = this.#pull;
  }

  /** Of bodies in joints the joint solve hands over velocities of the step's middle, less what Bullet will add. */
  #add(link: StruckBody, sign: 1 | -1, dt: number): void {
    if (!link.movable) return;
    const pull = this.#pullOf(link, sign);
    this.#rest = Math.max(this.#rest, Math.abs(pull));
    if (link.jointed) this.#lead += pull * dt;
    else if (!this.stays(link)) this.#pull += pull;
  }

  #pullOf({ body: { gravity } }: StruckBody, sign: 1 | -1): number {
    const [x, y, z] = gravity;
    return sign * (x * this.normal[0]! + y * this.normal[1]! + z * this.normal[2]!);
  }

  /**
   * Whether it happens in this step of `dt` seconds, before `until`. What would be back within the step does not bounce but rests: it is
   * left to the solver, unless it comes faster than rest can be told from.
   */
  comes(dt: number, until: number): boolean {
    if (this.a.isSpent || this.b.isSpent) return false;
    const { approach, gap } = this;
    const square = approach ** 2 + 2 * this.#pull * gap;
    const left = gap < 0 && square < 0;
    this.speed = left ? approach : Math.sqrt(square);
    if (!(this.speed >= OVER)) return false;
    if (approach >= 0) this.time = left ? 0 : (2 * gap) / (approach + this.speed);
    else if (gap >= 0 && this.#pull > 0) this.time = (this.speed - approach) / this.#pull;
    else return false;
    if (this.time < -dt) this.#beginNow(approach);
    return this.time < until && Math.max(2 * this.returned, this.speed / 2) > this.#rest * dt;
  }

  /** An overlap from earlier steps says nothing of when they met, nor how fast. */
  #beginNow(approach: number): void {
    this.time = 0;
    this.speed = approach;
  }

  /**
   * To Bullet's solver, as something that does not come back. It stays as deep as it is: above the slop Bullet would let it
   * fall by one more slop, in every step.
   */
  handOver(slop: number): void {
    this.point.restitution = 0;
    this.point.solverDistance = Math.min(this.#depth, -slop);
  }

  /** The share of the approach that has to stand in Bullet's row, so that weight leaves what is due after `dt`. */
  shareAt(dt: number): number {
    const { approach, returned, time } = this;
    return approach > 0 ? Math.max(0, returned - this.#pull * (dt - time)) / approach : 0;
  }

  /** m/s. */
  get returned(): number {
    return this.speed >= this.least ? this.bounce * this.speed : 0;
  }
}
