import type { Vec3 } from '../../fields/types.js';
import { add, length, scale, subtract } from '../../base/math.js';

/** Share of the way left that it takes per second: so it comes to rest by its strength, without overshooting. */
const HASTE = 12.5;

/** m/s²: the least that lifts things, two and a half times their weight. */
const LEAST_STRENGTH = 25;

const shortened = (v: Vec3, most: number): Vec3 => scale(v, Math.min(1, most / (length(v) || 1)));

/** For a snapshot. */
export interface KeptHand {
  position: Vec3;
  velocity: Vec3;
  topSpeed: number;
}

/**
 * What holds the other end of a drag's spring. It goes to where the pointer is, but as a hand does: a pointer may jump by
 * metres in one event, and a spring stretched so far tears what it holds. It is held back where the body can't follow.
 */
export class Hand {
  position: Vec3;
  velocity: Vec3 = [0, 0, 0];
  readonly #topSpeed: number;
  /** m/s²: what it moves gets no greater acceleration. */
  readonly strength: number;

  constructor(position: Vec3, topSpeed: number) {
    this.position = position;
    this.#topSpeed = topSpeed;
    this.strength = Math.max(LEAST_STRENGTH, HASTE * topSpeed);
  }

  save(): KeptHand {
    return { position: [...this.position], velocity: [...this.velocity], topSpeed: this.#topSpeed };
  }

  static from({ position, velocity, topSpeed }: KeptHand): Hand {
    const hand = new Hand([...position], topSpeed);
    hand.velocity = [...velocity];
    return hand;
  }

  /** One step towards `target`, at most `reach` away from the grabbed point, which is at `point` and moves at `rate`. */
  move(target: Vec3, point: Vec3, rate: Vec3, reach: number, dt: number): void {
    const ahead = subtract(this.position, point);
    if (length(ahead) > reach) {
      this.position = add(point, shortened(ahead, reach));
      this.velocity = shortened(rate, this.#topSpeed);
    }
    const wanted = shortened(scale(subtract(target, this.position), HASTE), this.#topSpeed);
    const change = shortened(subtract(wanted, this.velocity), this.strength * dt);
    this.velocity = add(this.velocity, change);
    this.position = add(this.position, scale(this.velocity, dt));
  }
}
