import type { Vec3 } from '../../fields/types.js';
import { add, AXES, compose, cross, length, scale, subtract } from '../../base/math.js';
import type { Body } from '../../dynamics/body.js';
import { applyInertia, applyInverseInertia } from '../../dynamics/inertia.js';
import type { Simulation } from '../../dynamics/simulation.js';
import { backward, factor, forward, rowOf } from '../../base/cholesky.js';
import { BODY_BLOCK, SIDE } from '../../solver/joints/blocks.js';
import { holds, isJointed } from '../../dynamics/jointed.js';
import { otherEnd } from '../../dynamics/other-end.js';
import type { RowSystem } from '../../solver/joints/row-system.js';
import { SWIFTNESS, TOP_SPEED } from './effects.js';
import { Hand, type KeptHand } from './hand.js';

/**
 * rad/s that a drag turns a body on its joints, at most: a chain that goes taut faster than this cracks like a whip, and its
 * joints open (measured: eight links of 1 m yanked past their end open by 3 µm at 1/120 s, at twice the speed by 0.3 m).
 */
const SWING = 4;

/** Share of its spin per second that a held body loses: it hangs in a hand, not in a bearing. */
const GRIP = 4;

/**
 * Radii of gyration that an arm counts for at most: how a body gives way along it and across differs by the square, and from
 * 10⁸ on double precision has no digits left for the lesser.
 */
const LONGEST_ARM = 1e5;

/**
 * The spring between a hand and the grabbed point: stiff in proportion to the mass that it has to move, with the damper that
 * just lets it not overshoot. Both act by the velocity at the end of the step (implicit Euler), which is stable for any mass
 * and step, and takes a critically damped spring to one: of an offset s at rest, s (1 + n h / (1 + h)) / (1 + h)ⁿ is left after
 * n steps, where h is SWIFTNESS times the step.
 */
export class DragSpring {
  readonly #simulation: Simulation;
  readonly #body: Body;
  /** In the body's frame. */
  readonly #grip: Vec3;
  /** Of the body and all that hangs on it by joints, kg. */
  readonly #mass: number;
  readonly #matrix = new Float64Array(rowOf(3));
  readonly #vector = new Float64Array(3);
  readonly #load = new Float64Array(SIDE);
  #hand: Hand;

  constructor(simulation: Simulation, body: Body, grip: Vec3) {
    this.#simulation = simulation;
    this.#body = body;
    this.#grip = grip;
    this.#mass = hangingMass([body]);
    this.#hand = new Hand(this.point, Math.min(TOP_SPEED, SWING * this.#lever()));
  }

  get point(): Vec3 {
    return compose(this.#body.pose(), { p: this.#grip, q: [0, 0, 0, 1] }).p;
  }

  get #arm(): Vec3 {
    const { mass, moments } = this.#body.mass;
    const arm = subtract(this.point, this.#body.centerOfMassWorld());
    const longest = LONGEST_ARM * Math.sqrt(Math.min(...moments) / mass);
    return scale(arm, Math.min(1, longest / length(arm)) || 1);
  }

  /** From the centre of mass to the farthest joint, or to the grabbed point; on its own a body has none. */
  #lever(): number {
    if (!isJointed(this.#body)) return Infinity;
    const centre = this.#body.centerOfMassWorld();
    const ends = [...this.#body.joints]
      .filter(holds)
      .flatMap((joint) => [
        ...(joint.body1 === this.#body ? [joint.anchorOn(1)] : []),
        ...(joint.body2 === this.#body ? [joint.anchorOn(2)] : []),
      ]);
    return Math.max(...[this.point, ...ends].map((end) => length(subtract(end, centre))));
  }

  save(): KeptHand {
    return this.#hand.save();
  }

  goOn(kept: KeptHand): void {
    this.#hand = Hand.from(kept);
  }

  /** The hand makes its step. It is no farther away than where the spring pulls with all its strength. */
  move(target: Vec3, dt: number): void {
    const { linear, angular } = this.#body.velocityAtOrigin();
    const arm = subtract(this.point, this.#body.pose().p);
    const reach = this.#hand.strength / SWIFTNESS ** 2;
    this.#hand.move(target, this.point, add(linear, cross(angular, arm)), reach, dt);
  }

  /** N s that the spring and the hand's own motion give in a step, if the point stood still. */
  #pull(dt: number): Vec3 {
    const { position, velocity } = this.#hand;
    const stretch = scale(subtract(position, this.point), SWIFTNESS ** 2);
    return scale(add(stretch, scale(velocity, 2 * SWIFTNESS)), this.#mass * dt);
  }

  /** N s per m/s of the point at the end of the step. */
  #drag(dt: number): number {
    const h = SWIFTNESS * dt;
    return this.#mass * h * (h + 2);
  }

  /** On a body that no joint holds: forces for this step. */
  push(dt: number): void {
    const { body } = this.#body;
    const { scratch } = this.#simulation.engine;
    const arm = this.#arm;
    const impulse = this.#impulse(arm, dt);
    body.applyCentralForce(scratch.vector(...scale(impulse, 1 / dt)));
    body.applyTorque(scratch.vector(...scale(cross(arm, impulse), 1 / dt)));
  }

  /** (W + 1 / drag) J = pull / drag - v, where W is what the body itself gives way. */
  #impulse(arm: Vec3, dt: number): Vec3 {
    const drag = this.#drag(dt);
    const matrix = this.#matrix;
    const vector = this.#vector;
    AXES.forEach((axis, i) => {
      const inverseMass = add(
        scale(axis, 1 / this.#body.mass.mass),
        cross(applyInverseInertia(this.#body, cross(arm, axis)), arm),
      );
      for (let j = 0; j <= i; j++) matrix[rowOf(i) + j] = inverseMass[j]! + axis[j]! / drag;
    });
    const short = subtract(scale(this.#pull(dt), 1 / drag), this.#rate(arm, dt));
    vector.set(short);
    factor(matrix, 0, 3);
    forward(matrix, 0, 3, vector, 0);
    backward(matrix, 0, 3, vector, 0);
    return [vector[0]!, vector[1]!, vector[2]!];
  }

  /** Of the point at the end of the step, if nobody held it. */
  #rate(arm: Vec3, dt: number): Vec3 {
    const { pointer, mass, gravity } = this.#body;
    const load = this.#load;
    this.#simulation.engine.reader.load(pointer, load, 0);
    const [vx, vy, vz, wx, wy, wz] = this.#simulation.bodies.velocityOf(this.#body);
    const force: Vec3 = [load[0]!, load[1]!, load[2]!];
    const torque: Vec3 = [load[3]!, load[4]!, load[5]!];
    const linear = add([vx!, vy!, vz!], scale(add(gravity, scale(force, 1 / mass.mass)), dt));
    const angular = add([wx!, wy!, wz!], scale(applyInverseInertia(this.#body, torque), dt));
    return add(linear, cross(angular, arm));
  }

  /** Takes from its spin. */
  slow(): void {
    const { body } = this.#body;
    const { angular } = this.#body.velocityAtOrigin();
    body.applyTorque(
      this.#simulation.engine.scratch.vector(...scale(applyInertia(this.#body, angular), -GRIP)),
    );
  }

  /**
   * On a body that joints hold: into the momentum and the resistance that the joint solve sees, so that all that hangs
   * together gives way as it can, and no joint is torn.
   */
  pullIn({ resisting, momentum }: RowSystem, i: number, dt: number): void {
    const arm = this.#arm;
    resisting.set(i, this.#resistance(arm, dt, resisting.get(i) ?? new Float64Array(BODY_BLOCK)));
    const pull = this.#pull(dt);
    const turn = cross(arm, pull);
    for (let n = 0; n < 3; n++) {
      momentum[i * SIDE + n]! += pull[n]!;
      momentum[i * SIDE + 3 + n]! += turn[n]!;
    }
  }

  /** Adds that of a damper at the end of the arm. */
  #resistance(arm: Vec3, dt: number, block: Float64Array): Float64Array {
    const drag = this.#drag(dt);
    const [x, y, z] = arm;
    const crossed = [0, -z, y, z, 0, -x, -y, x, 0];
    for (let r = 0; r < 3; r++) {
      const turning = rowOf(3 + r);
      block[rowOf(r) + r]! += drag;
      for (let c = 0; c < 3; c++) block[turning + c]! += drag * crossed[r * 3 + c]!;
      for (let c = 0; c <= r; c++) block[turning + 3 + c]! -= drag * arm[r]! * arm[c]!;
      block[turning + 3 + r]! += drag * (x * x + y * y + z * z);
    }
    return block;
  }
}

/** Of bodies and of all movable ones that joints tie to them, kg. */
export function hangingMass(bodies: Iterable<Body>): number {
  const found = new Set(bodies);
  for (const each of found)
    for (const joint of each.joints) {
      const other = otherEnd(joint, each);
      if (holds(joint) && other?.movable) found.add(other);
    }
  return [...found].reduce((sum, each) => sum + each.mass.mass, 0);
}
