import { PARTICLE, type Shown } from '../../../physics-core/particles.js';

/** The particles of one frame, and in which order they are drawn. */
export class Seen {
  count = 0;
  /** Where each is, in what x3dom draws: x, y, z. */
  places = new Float64Array(0);
  /** Seconds. */
  ages = new Float64Array(0);
  /** Where that of each begins in `motion`, that of all. */
  moves = new Uint32Array(0);
  motion: Float64Array = new Float64Array(0);
  order = new Uint32Array(0);
  /** The corners of the box in which all of them are. */
  readonly low = [0, 0, 0];
  readonly high = [0, 0, 0];

  /** Those that live `since` seconds before the end of the last step, the oldest first; `length`: metres of a unit. */
  take({ cloud, first, time }: Shown, since: number, length: number): void {
    this.#grow(cloud.count - first);
    const { motion, born, count } = cloud;
    const { places, ages, moves, order } = this;
    const [perMetre, now] = [1 / length, time - since];
    let seen = 0;
    for (let k = first; k < count; k++) {
      const age = now - born[k]!;
      // It is born after this frame.
      if (age < 0) continue;
      const from = k * PARTICLE;
      const at = 3 * seen;
      places[at] = (motion[from]! - since * motion[from + 3]!) * perMetre;
      places[at + 1] = (motion[from + 1]! - since * motion[from + 4]!) * perMetre;
      places[at + 2] = (motion[from + 2]! - since * motion[from + 5]!) * perMetre;
      ages[seen] = age;
      moves[seen] = from;
      order[seen] = seen;
      seen++;
    }
    this.motion = motion;
    this.count = seen;
    for (let axis = 0; axis < 3; axis++) this.#bound(axis);
  }

  #bound(axis: number): void {
    const { places } = this;
    const end = 3 * this.count;
    let low = Infinity;
    let high = -Infinity;
    for (let at = axis; at < end; at += 3) {
      const value = places[at]!;
      if (value < low) low = value;
      if (value > high) high = value;
    }
    this.low[axis] = low;
    this.high[axis] = high;
  }

  #grow(count: number): void {
    if (this.ages.length >= count) return;
    const room = 2 * count;
    this.places = new Float64Array(3 * room);
    this.ages = new Float64Array(room);
    this.moves = new Uint32Array(room);
    this.order = new Uint32Array(room);
  }
}
