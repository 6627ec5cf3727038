import { MET } from './collide/obstacles.js';
import { Drift } from './drift.js';
import type { Moving } from './moving.js';

/** No time. */
const NOTHING = new Drift();

/** How a particle goes relative to what it touches. */
export class Touch {
  readonly #moving: Moving;
  readonly #met: Float64Array;
  /** How fast that is where it is touched, m/s. */
  readonly surface = new Float64Array(3);
  /** Along the surface: which way `slide` found that it slides. */
  readonly along = new Float64Array(3);

  constructor(moving: Moving, met: Float64Array) {
    this.#moving = moving;
    this.#met = met;
  }

  /** What is along the normal, relative to the surface, m/s. */
  approach(): number {
    const met = this.#met;
    const { velocity } = this.#moving;
    let speed = 0;
    for (let i = 0; i < 3; i++) speed += (velocity[i]! - this.surface[i]!) * met[MET.normal + i]!;
    return speed;
  }

  /** How fast it is along the normal, in the world, m/s: drag goes by that. */
  climb(): number {
    const { velocity } = this.#moving;
    let speed = 0;
    for (let i = 0; i < 3; i++) speed += velocity[i]! * this.#met[MET.normal + i]!;
    return speed;
  }

  /** What pushes it along the normal, m/s². */
  pull(): number {
    const { push } = this.#moving;
    let pull = 0;
    for (let i = 0; i < 3; i++) pull += push[i]! * this.#met[MET.normal + i]!;
    return pull;
  }

  /** How fast it slides, m/s, now or after what drag and push do to it in the rest of the step. */
  slide(later = NOTHING): number {
    const { left, speedOfPush } = later;
    const { velocity, push } = this.#moving;
    const met = this.#met;
    const along = this.along;
    let off = 0;
    for (let i = 0; i < 3; i++) {
      along[i] = velocity[i]! * left + push[i]! * speedOfPush - this.surface[i]!;
      off += along[i]! * met[MET.normal + i]!;
    }
    let square = 0;
    for (let i = 0; i < 3; i++) {
      along[i] = along[i]! - off * met[MET.normal + i]!;
      square += along[i]! ** 2;
    }
    const speed = Math.sqrt(square);
    if (speed > 0) for (let i = 0; i < 3; i++) along[i] = along[i]! / speed;
    return speed;
  }
}
