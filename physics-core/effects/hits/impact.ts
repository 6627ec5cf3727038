import { ContactPoint } from '../../engine/contact-point.js';
import type { Engine } from '../../engine/engine.js';
import type { StruckBody } from './struck-body.js';

/** Below this approach a hit is over: what bounces less and less would go on for ever, m/s. */
export const OVER = 1e-3;

/** A point where something round touches: whether it hits in this step, when, and how hard. */
export class Impact {
  readonly point: ContactPoint;
  a!: StruckBody;
  b!: StruckBody;
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
    this.point = new ContactPoint(ammo);
  }

  /** Whether one of both lies on something, as in a heap. */
  get borne(): boolean {
    return this.a.borne || this.b.borne;
  }

  get approach(): number {
    const { point } = this;
    return this.#lead - point.speed(point.normal(0), point.normal(1), point.normal(2));
  }

  weigh(dt: number): void {
    this.#depth = this.point.solverDistance;
    this.#pull = this.#lead = this.#rest = 0;
    this.#weigh(this.a, -1, dt);
    this.#weigh(this.b, 1, dt);
    if (!this.borne) this.#rest = this.#pull;
  }

  /** Of bodies in joints the joint solve hands over velocities of the step's middle, less what Bullet will add. */
  #weigh({ body, movable, jointed, carried }: StruckBody, sign: 1 | -1, dt: number): void {
    if (!movable) return;
    const { point } = this;
    const [x, y, z] = body.gravity;
    const pull = sign * (x * point.normal(0) + y * point.normal(1) + z * point.normal(2));
    this.#rest = Math.max(this.#rest, Math.abs(pull));
    if (jointed) this.#lead += pull * dt;
    // What lies on something else does not fall away from the other.
    else if (!(carried && pull < 0)) this.#pull += pull;
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
