import { METS, MET } from './collide/obstacles.js';
import type { Drift } from './drift.js';
import { copy, type Moving } from './moving.js';
import type { Pushed } from './pushed.js';
import type { Touch } from './touch.js';

/** What bears a particle that does not leave the surface that it met. */
export class Lying {
  readonly #moving: Moving;
  readonly #touch: Touch;
  readonly #pushed: Pushed;
  readonly #met: Float64Array;
  /** That as it was met, and how it bears, m/s²: from below, and by friction the other way than `#braked`. */
  readonly #borne = new Float64Array(METS);
  readonly #braked = new Float64Array(3);
  #bearing = 0;
  #braking = 0;

  constructor(moving: Moving, touch: Touch, met: Float64Array, pushed: Pushed) {
    this.#moving = moving;
    this.#touch = touch;
    this.#met = met;
    this.#pushed = pushed;
  }

  /** Nothing bears it. */
  end(): void {
    this.#bearing = 0;
  }

  /**
   * At the end of the step it goes as what bears it, which brakes it: to a stand, at most. `pull`: what would take it in,
   * m/s²; `rest`: what is left of the step.
   */
  begin(friction: number, pull: number, rest: Drift): void {
    if (pull >= 0) return;
    const { push } = this.#moving;
    const { along } = this.#touch;
    const met = this.#met;
    copy(met, this.#borne);
    for (let i = 0; i < 3; i++) push[i] = push[i]! - pull * met[MET.normal + i]!;
    this.#bearing = -pull;
    this.#braking = Math.min(this.#touch.slide(rest) / rest.speedOfPush, friction * -pull);
    copy(along, this.#braked);
    for (let i = 0; i < 3; i++) push[i] = push[i]! - this.#braking * along[i]!;
  }

  /** What bore it through the time that was taken last was pressed and dragged by it. */
  press(mass: number): void {
    if (this.#bearing === 0 || mass === 0) return;
    const borne = this.#borne;
    const seconds = this.#moving.drift.speedOfPush;
    this.#pushed.push(borne, borne, MET.normal, -mass * this.#bearing * seconds);
    if (this.#braking > 0)
      this.#pushed.push(borne, this.#braked, 0, mass * this.#braking * seconds);
  }
}
