import { compose7, dot3 } from '../../base/flat-math.js';
import { conjugate, rotate } from '../../base/math.js';
import type { Body } from '../../dynamics/body.js';
import { levels } from '../../dynamics/levels.js';
import { POSE } from '../../dynamics/poses.js';
import type { Simulation } from '../../dynamics/simulation.js';
import { VELOCITY } from '../../engine/moving-bodies.js';
import type { Vec3 } from '../../fields/types.js';
import { MET_AHEAD, MOST_PARTS } from '../../solver/tolerances.js';
import { distanceTo, within } from '../contacts/part-box.js';
import { FAR } from './effects.js';
import { speedOfEnds } from './ends.js';
import { areJoined, FastBodies } from './fast-bodies.js';

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
    const { velocities } = this.#simulation.bodies;
    const at = body.slot * VELOCITY + 3;
    const spin: Vec3 = [velocities[at]!, velocities[at + 1]!, velocities[at + 2]!];
    return speedOfEnds(body, rotate(conjugate(body.poseInBullet().q), spin));
  }

  /** Of anything that it may strike in the step the least extent and how far ahead it is met, metres; Infinity where there is nothing. */
  #thinnest(body: Body, dt: number): number {
    const { bodies, poses } = this.#simulation;
    const { moving, velocities } = bodies;
    const at = body.slot * VELOCITY;
    const reach = body.reach + dt * Math.sqrt(dot3(velocities, at, velocities, at));
    compose7(this.#centre, 0, poses.current, body.slot * POSE, body.centerOfMass);
    let least = Infinity;
    for (let slot = 0; slot < moving.slots; slot++) {
      const other = bodies.in(slot);
      if (!other?.active || other === body || !this.#isNear(other, reach)) continue;
      // All of it triangles.
      const solid = Number.isFinite(other.leastExtent) ? other.leastExtent : 0;
      const thickness = solid + MET_AHEAD * Math.min(body.reach, other.reach);
      if (thickness >= least || areJoined(body, other)) continue;
      if (this.#isWithin(reach, other)) least = thickness;
    }
    return least;
  }

  /** Whether balls around both meet: most are far, and cost no more than this. */
  #isNear(other: Body, reach: number): boolean {
    const centre = this.#centre;
    const place = this.#other;
    compose7(place, 0, this.#simulation.poses.current, other.slot * POSE, other.centerOfMass);
    let square = 0;
    for (let i = 0; i < 3; i++) square += (place[i]! - centre[i]!) ** 2;
    return square <= (reach + other.reach) ** 2;
  }

  /** Whether a box around any of its parts is met. */
  #isWithin(reach: number, other: Body): boolean {
    const [x, y, z] = this.#centre;
    const point = within(other.poseInBullet(), [x!, y!, z!]);
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
