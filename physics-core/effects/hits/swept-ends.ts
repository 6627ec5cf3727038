import { compose7 } from '../../base/flat-math.js';
import { conjugate, rotate, subtract } from '../../base/math.js';
import { lengthOf } from '../../base/exact/index.js';
import type { Body } from '../../dynamics/body.js';
import { levels } from '../../dynamics/levels.js';
import { POSE } from '../../dynamics/poses.js';
import type { Simulation } from '../../dynamics/simulation.js';
import { VELOCITY } from '../../engine/moving-bodies.js';
import type { Vec3 } from '../../fields/types.js';
import { MOST_PARTS } from '../../solver/tolerances.js';
import { distanceTo, within } from '../contacts/part-box.js';
import { FAR } from './effects.js';
import { speedOfEnds } from './ends.js';
import { areJoined, FastBodies } from './fast-bodies.js';

/** Bullet meets what comes nearer than this share of the smaller one's reach (gContactBreakingThreshold): so far it looks ahead. */
const AHEAD = 0.02;

/**
 * Ends of rods, blades and spokes go round so fast that they would be before a thing at the beginning of a step and behind it
 * at the end. Where something lies within their reach the step is split, so that in each part they go no farther than both
 * are thick: then they are found in touch, on the side from which they came.
 */
export class SweptEnds extends FastBodies {
  readonly #simulation: Simulation;
  readonly #centre = new Float64Array(POSE);
  readonly #other = new Float64Array(POSE);

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
    let most = 1;
    for (const node of this.causes) {
      const body = node as Body;
      if (body.active && body.movable && !body.sleeping) most = Math.max(most, this.#of(body, dt));
    }
    return most;
  }

  #of(body: Body, dt: number): number {
    const way = this.#speed(body) * dt;
    if (!(way > FAR * body.leastExtent)) return 1;
    const parts = way / (FAR * (body.leastExtent + this.#thinnest(body, dt)));
    if (parts > MOST_PARTS) reportTooFast(body, way / dt, dt, parts);
    return parts;
  }

  #speed(body: Body): number {
    const [x, y, z] = this.#spin(body);
    const { q } = body.poseInBullet();
    return speedOfEnds(body, rotate(conjugate(q), [x, y, z]));
  }

  #spin({ slot }: Body): Vec3 {
    const at = slot * VELOCITY + 3;
    const [x, y, z] = this.#simulation.bodies.velocities.subarray(at, at + 3);
    return [x!, y!, z!];
  }

  /** Of anything that it may strike in the step the least extent and how far ahead it is met, metres; Infinity where there is nothing. */
  #thinnest(body: Body, dt: number): number {
    const { bodies, poses } = this.#simulation;
    const at = body.slot * VELOCITY;
    const [x, y, z] = bodies.velocities.subarray(at, at + 3);
    const reach = body.reach + dt * lengthOf([x!, y!, z!]);
    compose7(this.#centre, 0, poses.current, body.slot * POSE, body.centerOfMass);
    let least = Infinity;
    for (const other of bodies) {
      if (other === body || !other.active) continue;
      // All of it triangles.
      const solid = Number.isFinite(other.leastExtent) ? other.leastExtent : 0;
      const thickness = solid + AHEAD * Math.min(body.reach, other.reach);
      if (thickness >= least || areJoined(body, other)) continue;
      if (this.#isWithin(reach, other)) least = thickness;
    }
    return least;
  }

  #isWithin(reach: number, other: Body): boolean {
    compose7(this.#other, 0, this.#simulation.poses.current, other.slot * POSE, other.centerOfMass);
    const [x, y, z] = this.#centre;
    const from: Vec3 = [x!, y!, z!];
    const [a, b, c] = this.#other;
    if (lengthOf(subtract(from, [a!, b!, c!])) > reach + other.reach) return false;
    const point = within(other.poseInBullet(), from);
    return other.solidParts.some((part) => distanceTo(part, point) <= reach);
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
