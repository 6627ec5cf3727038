import { hypot } from '../../base/exact/index.js';
import type { Engine } from '../../engine/engine.js';
import { HitPath } from './hit-path.js';
import type { HitShape } from './hit-shape.js';
import type { Impact } from './impact.js';

/** Looks at where both are: each squares the error. */
const MOST_LOOKS = 8;

/** Seconds within which the time is known. */
const EXACT = 1e-12;

/** Nearer to the middle than this a ball has no direction out, metres. */
const INSIDE = 1e-9;

const local = new Float64Array(3);
const clamped = new Float64Array(3);

/**
 * Where a ball touches another solid at the very time that it does: Bullet's point and normal are those of the pose that
 * it looked at, which is off by up to a whole step. On curved paths and surfaces one plane of contact leads to the next.
 */
export class TimeOfImpact {
  readonly #engine: Engine;
  readonly #ball = new HitPath();
  readonly #other = new HitPath();
  /** From the other solid into the ball. */
  readonly #normal = new Float64Array(3);
  readonly #point = new Float64Array(3);
  readonly #ballArm = new Float64Array(3);
  readonly #otherArm = new Float64Array(3);

  /** The ball is A. */
  #first = false;

  constructor(engine: Engine) {
    this.#engine = engine;
  }

  /**
   * Gives the hit its normal, arms and gap at the start of the step: Bullet rounds the edges of boxes and cylinders off by
   * their margin, and meets them late.
   */
  measure(hit: Impact, dt: number): void {
    if (!this.#begin(hit, dt)) return;
    const gap = this.#look(0);
    if (gap !== gap) return;
    this.#hand(hit);
    hit.measured(gap, dt);
  }

  /** The same at its own time, searched from the one that it has. False: it has to do with what it has. */
  locate(hit: Impact, dt: number): boolean {
    if (!this.#begin(hit, dt)) return false;
    const time = this.#search(hit.time, dt);
    if (time !== time) return false;
    this.#hand(hit);
    hit.touchAt(time, dt);
    return true;
  }

  #hand(hit: Impact): void {
    const sign = this.#first ? 1 : -1;
    for (let i = 0; i < 3; i++) hit.normal[i] = sign * this.#normal[i]!;
    hit.armA.set(this.#first ? this.#ballArm : this.#otherArm);
    hit.armB.set(this.#first ? this.#otherArm : this.#ballArm);
  }

  /** False: nothing of both is known in closed form. */
  #begin(hit: Impact, dt: number): boolean {
    const { a, b, shapeA, shapeB } = hit;
    if (!shapeA || !shapeB) return false;
    this.#first = shapeA.kind === 'ball';
    if (!this.#first && shapeB.kind !== 'ball') return false;
    const pathA = this.#first ? this.#ball : this.#other;
    const pathB = this.#first ? this.#other : this.#ball;
    pathA.begin(this.#engine, a, shapeA, dt);
    pathB.begin(this.#engine, b, shapeB, dt);
    if (hit.stays(a)) pathA.stay();
    if (hit.stays(b)) pathB.stay();
    return !pathA.isDriven && !pathB.isDriven;
  }

  /** NaN: it can't be found within a step. */
  #search(from: number, dt: number): number {
    let time = from;
    for (let i = 0; i < MOST_LOOKS; i++) {
      const gap = this.#look(time);
      const approach = this.#approach(time);
      const pull = this.#other.pullAlong(this.#normal) - this.#ball.pullAlong(this.#normal);
      const square = approach ** 2 + 2 * pull * gap;
      if (!(approach > 0) || !(square >= 0)) return NaN;
      const step = (2 * gap) / (approach + Math.sqrt(square));
      time += step;
      if (!(Math.abs(time) <= 2 * dt)) return NaN;
      if (Math.abs(step) < EXACT) return time;
    }
    return time;
  }

  /** Both at a time, with normal, point and arms; the distance of their surfaces. */
  #look(time: number): number {
    this.#ball.at(time);
    this.#other.at(time);
    const radius = this.#ball.shape.half[0];
    const away = this.#nearest(this.#other.shape);
    this.#other.writeArm(this.#otherArm, this.#point);
    const { centre } = this.#ball;
    for (let i = 0; i < 3; i++) this.#point[i] = centre[i]! - radius * this.#normal[i]!;
    this.#ball.writeArm(this.#ballArm, this.#point);
    return away - radius;
  }

  #approach(time: number): number {
    return (
      this.#other.speed(this.#otherArm, this.#normal, time) -
      this.#ball.speed(this.#ballArm, this.#normal, time)
    );
  }

  /** Writes the point of the other solid nearest to the ball's centre, and the normal there; returns the distance. */
  #nearest({ kind, half }: HitShape): number {
    const { centre, axes } = this.#other;
    for (let i = 0; i < 3; i++) local[i] = this.#ball.centre[i]! - centre[i]!;
    if (kind === 'ball') return this.#fromBall(half[0]);
    this.#intoAxes(axes);
    if (kind === 'box') for (let i = 0; i < 3; i++) clamped[i] = within(local[i]!, half[i]!);
    else clampToCylinder(half);
    return this.#fromClamped();
  }

  #fromBall(radius: number): number {
    const distance = hypot(local[0]!, local[1]!, local[2]!);
    if (distance < INSIDE) return NaN;
    for (let i = 0; i < 3; i++) {
      this.#normal[i] = local[i]! / distance;
      this.#point[i] = this.#other.centre[i]! + radius * this.#normal[i]!;
    }
    return distance - radius;
  }

  /** Of `local`, by the columns of the axes. */
  #intoAxes(axes: Float64Array): void {
    const x = local[0]!;
    const y = local[1]!;
    const z = local[2]!;
    for (let i = 0; i < 3; i++)
      local[i] = axes[3 * i]! * x + axes[3 * i + 1]! * y + axes[3 * i + 2]! * z;
  }

  /** A centre within the other solid has no nearest point that could be trusted. */
  #fromClamped(): number {
    const x = local[0]! - clamped[0]!;
    const y = local[1]! - clamped[1]!;
    const z = local[2]! - clamped[2]!;
    const distance = hypot(x, y, z);
    if (distance < INSIDE) return NaN;
    const { centre, axes } = this.#other;
    for (let i = 0; i < 3; i++) {
      this.#normal[i] = (axes[i]! * x + axes[3 + i]! * y + axes[6 + i]! * z) / distance;
      this.#point[i] =
        centre[i]! +
        axes[i]! * clamped[0]! +
        axes[3 + i]! * clamped[1]! +
        axes[6 + i]! * clamped[2]!;
    }
    return distance;
  }
}

const within = (value: number, most: number): number => Math.max(-most, Math.min(most, value));

/** About y. */
function clampToCylinder([radius, half]: HitShape['half']): void {
  const out = hypot(local[0]!, local[2]!);
  const share = out > radius ? radius / out : 1;
  clamped[0] = local[0]! * share;
  clamped[1] = within(local[1]!, half);
  clamped[2] = local[2]! * share;
}
