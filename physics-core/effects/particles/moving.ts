import { Drift } from './drift.js';

// Of a few numbers: `set` and `fill` take ten times as long.

export function copy(from: Float64Array, to: Float64Array): void {
  for (let i = 0; i < to.length; i++) to[i] = from[i]!;
}

export function clear(numbers: Float64Array): void {
  for (let i = 0; i < numbers.length; i++) numbers[i] = 0;
}

/** A particle that moves through a step. */
export class Moving {
  /** Metres: where it is, and where it comes if nothing is in its way. */
  readonly from = new Float64Array(3);
  readonly to = new Float64Array(3);
  /** m/s, and what pushes, m/s². */
  readonly velocity = new Float64Array(3);
  readonly push = new Float64Array(3);
  /** Beside its velocity, m/s: what bears it is where it is drawn, and has the speed that it was given in the next step only. */
  readonly lift = new Float64Array(3);
  /** What the time that was taken last does to it. */
  readonly drift = new Drift();
  /** Of its drag, 1/s. */
  damping = 0;

  /** `motion` holds its place and its velocity from `at` on. */
  read(motion: Float64Array, at: number, push: Float64Array, damping: number): void {
    for (let i = 0; i < 3; i++) {
      this.from[i] = motion[at + i]!;
      this.velocity[i] = motion[at + 3 + i]!;
    }
    this.damping = damping;
    this.free(push);
  }

  /** Returns whether it is as it was. */
  write(motion: Float64Array, at: number): boolean {
    let same = true;
    for (let i = 0; i < 3; i++) {
      if (motion[at + i] !== this.from[i] || motion[at + 3 + i] !== this.velocity[i]) same = false;
      motion[at + i] = this.from[i]!;
      motion[at + 3 + i] = this.velocity[i]!;
    }
    return same;
  }

  /** Nothing bears it. */
  free(push: Float64Array): void {
    copy(push, this.push);
    clear(this.lift);
  }

  /** From where it goes and where it comes if nothing is in its way, before anything of it is read. */
  lookAhead(motion: Float64Array, at: number, push: Float64Array, drift: Drift): this {
    const { wayOfSpeed, wayOfPush } = drift;
    for (let i = 0; i < 3; i++) {
      const start = (this.from[i] = motion[at + i]!);
      this.to[i] = start + motion[at + 3 + i]! * wayOfSpeed + push[i]! * wayOfPush;
    }
    return this;
  }

  take(seconds: number): Drift {
    return this.drift.take(this.damping, seconds);
  }

  /** Where it comes in such a time. */
  lead(seconds: number): void {
    const { wayOfSpeed, wayOfPush } = this.take(seconds);
    const lift = this.lift;
    for (let i = 0; i < 3; i++)
      this.to[i] =
        this.from[i]! +
        this.velocity[i]! * wayOfSpeed +
        this.push[i]! * wayOfPush +
        lift[i]! * seconds;
  }

  /** How fast it is after that. */
  speed(): void {
    const { left, speedOfPush } = this.drift;
    const velocity = this.velocity;
    for (let i = 0; i < 3; i++) velocity[i] = velocity[i]! * left + this.push[i]! * speedOfPush;
  }
}
