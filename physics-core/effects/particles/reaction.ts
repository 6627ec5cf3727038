import { MET, type Obstacles } from './collide/obstacles.js';
import type { Drift } from './drift.js';
import type { Lying } from './lying.js';
import { clear, copy, type Moving } from './moving.js';
import type { Pushed } from './pushed.js';
import type { Surface } from './surface.js';
import type { Touch } from './touch.js';

/** What becomes of the speed of a particle that meets something. */
export class Reaction {
  readonly #moving: Moving;
  readonly #touch: Touch;
  readonly #lying: Lying;
  readonly #met: Float64Array;
  readonly #obstacles: Obstacles;
  readonly #pushed: Pushed;
  readonly #borneBy = new Float64Array(3);

  constructor(
    moving: Moving,
    touch: Touch,
    lying: Lying,
    met: Float64Array,
    obstacles: Obstacles,
    pushed: Pushed,
  ) {
    this.#moving = moving;
    this.#touch = touch;
    this.#lying = lying;
    this.#met = met;
    this.#obstacles = obstacles;
    this.#pushed = pushed;
  }

  /** A wall throws it back. `above`: how far above the surface its arc was when the straight way met that, metres. */
  reflect(above: number): void {
    clear(this.#touch.surface);
    const approach = this.#touch.approach();
    if (approach >= 0) return;
    const change = this.#fallen(approach, this.#touch.pull(), above) - 2 * approach;
    const { velocity } = this.#moving;
    for (let i = 0; i < 3; i++) velocity[i] = velocity[i]! + change * this.#met[MET.normal + i]!;
  }

  /**
   * Newton's law of restitution, and Coulomb's of friction. What would be back within the step, `dt` seconds, does not leave
   * the surface: it bears it in the `rest` of the step.
   */
  react({ bounce, friction, mass }: Surface, dt: number, rest: Drift, above: number): void {
    const met = this.#met;
    const touch = this.#touch;
    this.#obstacles.velocityAt(met, touch.surface);
    const drawn = touch.approach();
    if (mass > 0) this.#pushed.addNormalVelocity(met, touch.surface);
    const approach = touch.approach();
    const pull = touch.pull();
    const fallen = approach < 0 ? this.#fallen(approach, pull, above) : 0;
    const back = approach < 0 ? bounce * (fallen - approach) : approach;
    const stays = 2 * back <= -pull * dt;
    if (approach < 0) {
      const given = this.#give(met, MET.normal, (stays ? 0 : back) - approach, mass);
      this.#rub(friction * given, mass);
    }
    const { lift } = this.#moving;
    for (let i = 0; i < 3; i++) lift[i] = (approach - drawn) * met[MET.normal + i]!;
    if (!stays || rest.speedOfPush === 0) return;
    const away = (Math.max(0, approach) * rest.left) / rest.speedOfPush;
    this.#lying.begin(friction, away + pull, rest);
  }

  /**
   * Ways are searched straight, and go along arcs: the speed that it would have gained on the last bit, m/s. Without it what
   * falls would rise less high than its bounce says, by a third of a millimetre at `game`.
   */
  #fallen(approach: number, pull: number, above: number): number {
    const { damping } = this.#moving;
    const square = approach * approach - 2 * (pull - damping * this.#touch.climb()) * above;
    return square > 0 ? Math.sqrt(square) + approach : 0;
  }

  /**
   * Changes its speed along a direction, as seen from the body, by so much, m/s: both give way, each by its mass. Returns what
   * it has of that itself.
   */
  #give(direction: Float64Array, at: number, change: number, mass: number): number {
    const { velocity } = this.#moving;
    const own =
      mass > 0 ? change / (1 + mass * this.#pushed.softness(this.#met, direction, at)) : change;
    for (let i = 0; i < 3; i++) velocity[i] = velocity[i]! + own * direction[at + i]!;
    if (mass > 0) this.#pushed.push(this.#met, direction, at, -mass * own);
    return own;
  }

  /**
   * Brakes it along the surface by as much of its own speed, m/s, at most to a stand: that of a body which others that struck
   * it in this step have taken along.
   */
  #rub(most: number, mass: number): void {
    if (mass === 0) {
      this.#brake(most, 0);
      return;
    }
    const met = this.#met;
    const { surface } = this.#touch;
    copy(surface, this.#borneBy);
    this.#obstacles.velocityAt(met, surface);
    this.#pushed.addVelocity(met, surface);
    this.#brake(most, mass);
    copy(this.#borneBy, surface);
  }

  #brake(most: number, mass: number): void {
    const speed = this.#touch.slide();
    if (speed === 0) return;
    const { along } = this.#touch;
    const softness = mass > 0 ? mass * this.#pushed.softness(this.#met, along, 0) : 0;
    this.#give(along, 0, -Math.min(speed, most * (1 + softness)), mass);
  }
}
