import { compose7, dot3 } from '../../base/flat-math.js';
import { conjugate, rotate } from '../../base/math.js';
import type { Body } from '../../dynamics/body.js';
import { levels } from '../../dynamics/levels.js';
import { POSE } from '../../dynamics/poses.js';
import type { Simulation } from '../../dynamics/simulation.js';
import { VELOCITY } from '../../engine/moving-bodies.js';
import type { Vec3 } from '../../fields/types.js';
import { MET_AHEAD, MOST_PARTS } from '../../solver/tolerances.js';
import { distanceTo, within } from '../contacts/part-distance.js';
import { FAR } from './effects.js';
import { speedOfEnds } from './ends.js';
import { areJoined, FastBodies } from './fast-bodies.js';

/** Numbers per ball: its middle and its radius. */
const BALL = 4;

/**
 * Ends of rods, blades and spokes go round so fast that they would be before a thing at the beginning of a step and behind it
 * at the end. Where something lies within their reach the step is split, so that in each part they go no farther than both
 * are thick: then they are found in touch, on the side from which they came.
 */
export class SweptEnds extends FastBodies {
  readonly #simulation: Simulation;
  readonly #place = new Float64Array(POSE);
  /** Balls around all bodies where the step begins, by slot: side by side in memory, since each that is fast asks all. */
  #balls = new Float64Array(0);

  constructor(simulation: Simulation) {
    super();
    this.#simulation = simulation;
  }

  /** Its ends will go far in the next step. */
  override need(
    body: Body,
    reason = 'its ends go more than half its least extent in a step',
  ): void {
    super.need(body, reason);
  }

  override parts(dt: number): number {
    this.#takeBalls();
    let most = 1;
    for (const node of this.causes) {
      const body = node as Body;
      if (body.active && body.movable && !body.sleeping) most = Math.max(most, this.#of(body, dt));
    }
    return most;
  }

  #takeBalls(): void {
    const { bodies, poses } = this.#simulation;
    const { slots } = bodies.moving;
    if (this.#balls.length < slots * BALL) this.#balls = new Float64Array(2 * slots * BALL);
    for (let slot = 0; slot < slots; slot++) {
      const body = bodies.in(slot);
      // No distance is less than NaN.
      this.#balls[slot * BALL + 3] = body?.active ? body.reach : NaN;
      if (!body?.active) continue;
      compose7(this.#place, 0, poses.current, slot * POSE, body.centerOfMass);
      for (let i = 0; i < 3; i++) this.#balls[slot * BALL + i] = this.#place[i]!;
    }
  }

  #of(body: Body, dt: number): number {
    const thinnest = this.#thinnest(body, dt);
    if (thinnest === Infinity) return 1;
    const way = this.#speed(body) * dt;
    if (!(way > FAR * body.leastExtent)) return 1;
    const parts = way / (FAR * (body.leastExtent + thinnest));
    if (parts > MOST_PARTS) reportTooFast(body, way / dt, dt, parts);
    return parts;
  }

  #speed(body: Body): number {
    const { velocities } = this.#simulation.bodies;
    const at = body.slot * VELOCITY + 3;
    const spin: Vec3 = [velocities[at]!, velocities[at + 1]!, velocities[at + 2]!];
    return speedOfEnds(body, rotate(conjugate(body.poseInBullet().q), spin));
  }

  /** Of anything that it may strike in the step the least extent and how far ahead it is met, metres; Infinity where there is nothing. */
  #thinnest(body: Body, dt: number): number {
    const { moving, velocities } = this.#simulation.bodies;
    const balls = this.#balls;
    const at = body.slot * VELOCITY;
    const reach = body.reach + dt * Math.sqrt(dot3(velocities, at, velocities, at));
    const own = body.slot * BALL;
    const x = balls[own]!;
    const y = balls[own + 1]!;
    const z = balls[own + 2]!;
    let least = Infinity;
    for (let slot = 0; slot < moving.slots; slot++) {
      const ball = slot * BALL;
      const dx = balls[ball]! - x;
      const dy = balls[ball + 1]! - y;
      const dz = balls[ball + 2]! - z;
      if (!(dx * dx + dy * dy + dz * dz <= (reach + balls[ball + 3]!) ** 2)) continue;
      least = Math.min(least, this.#thicknessOf(slot, body, reach));
    }
    return least;
  }

  /** Infinity where it can't be met. */
  #thicknessOf(slot: number, body: Body, reach: number): number {
    const other = this.#simulation.bodies.in(slot)!;
    if (other === body || areJoined(body, other)) return Infinity;
    const [x, y, z] = this.#balls.subarray(body.slot * BALL, body.slot * BALL + 3);
    const point = within(other.poseInBullet(), [x!, y!, z!]);
    if (!other.solidParts.some((part) => distanceTo(part, point) <= reach)) return Infinity;
    // All of it may be triangles.
    const solid = Number.isFinite(other.leastExtent) ? other.leastExtent : 0;
    return solid + MET_AHEAD * Math.min(body.reach, other.reach);
  }
}

function reportTooFast(body: Body, speed: number, dt: number, parts: number): void {
  const better = levels.find(({ timeStep }) => (parts * timeStep) / dt <= MOST_PARTS);
  body.report({
    code: 'too-fast',
    severity: 'warning',
    attribute: 'angularVelocity',
    value: speed,
    used: `${MOST_PARTS} parts of each step`,
    message: `${body.label} has ends that go ${Number(speed.toPrecision(2))} m/s and may pass through thin things at this accuracy; ${better ? `accuracy="${better.name}" or better finds what they strike` : 'no accuracy finds what they strike'}`,
  });
}
