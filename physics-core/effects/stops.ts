import type { Vec3 } from '../fields/types.js';
import { add, compose, conjugate, cross, dot, rotate, scale, subtract } from '../math.js';
import type { BodyNode } from '../nodes/body.js';
import type { SingleAxisHingeJointNode } from '../nodes/single-axis-hinge-joint.js';
import type { World } from '../world/world.js';
import { solveCholesky } from './cholesky.js';
import { Effect } from './effect.js';

/** Below this rate (rad/s) a stop holds instead of bouncing. */
const LEAST_BOUNCE = 0.01;

const ROWS = 6;

/** One row of a joint's velocity: linear direction or axis, as seen by each body. */
interface Row {
  linear: Vec3;
  angular1: Vec3;
  angular2: Vec3;
}

/**
 * Bullet's own limit rows rebound from a stop by themselves and hardly bounce when asked to. Where the angle would
 * pass a stop in the coming step, this sets its rate at once, solving all six rows of the joint together so that the
 * locked ones stay as they are (measured). Bullet's limits stay on behind it as a net.
 */
export class Stops extends Effect {
  readonly name = 'stops';
  readonly #world: World;
  readonly #matrix = new Float64Array(ROWS * ROWS);
  readonly #wanted = new Float64Array(ROWS);

  constructor(world: World) {
    super();
    this.#world = world;
  }

  override beforeStep(dt: number): void {
    for (const node of this.causes) {
      const joint = node as SingleAxisHingeJointNode;
      if (!joint.attached || asleep(joint.body1, joint.body2)) continue;
      const rate = joint.angleRate;
      const target = stopRate(joint, rate, dt);
      if (target !== undefined) this.#setRate(joint, target - rate);
    }
  }

  /** Changes the hinge's rate by `change` rad/s through impulses on both bodies. */
  #setRate(joint: SingleAxisHingeJointNode, change: number): void {
    const rows = rowsOf(joint);
    for (let i = 0; i < ROWS; i++) {
      for (let j = 0; j < ROWS; j++)
        this.#matrix[i * ROWS + j] = coupling(joint, rows[i]!, rows[j]!);
      this.#wanted[i] = 0;
    }
    this.#wanted[ROWS - 1] = change;
    if (!solveCholesky(this.#matrix, this.#wanted, ROWS)) return;
    this.#push(joint.body1, rows, 1);
    this.#push(joint.body2, rows, -1);
  }

  #push(body: BodyNode | undefined, rows: Row[], sign: 1 | -1): void {
    if (!body?.movable) return;
    let linear: Vec3 = [0, 0, 0];
    let angular: Vec3 = [0, 0, 0];
    rows.forEach((row, i) => {
      linear = add(linear, scale(row.linear, sign * this.#wanted[i]!));
      angular = add(
        angular,
        scale(sign > 0 ? row.angular1 : row.angular2, sign * this.#wanted[i]!),
      );
    });
    const { scratch } = this.#world.engine;
    body.body.applyCentralImpulse(scratch.vector(...linear));
    body.body.applyTorqueImpulse(scratch.vector(...angular));
    this.#world.bodies.readVelocity(body);
  }
}

const asleep = (a: BodyNode | undefined, b: BodyNode | undefined): boolean =>
  (!a?.movable || a.sleeping) && (!b?.movable || b.sleeping);

/** The rate the hinge shall have now; undefined where no stop is in its way. */
function stopRate(joint: SingleAxisHingeJointNode, rate: number, dt: number): number | undefined {
  const [low, high] = joint.stops;
  const angle = joint.angle;
  const stop =
    rate > 0 && angle + rate * dt > high
      ? high
      : rate < 0 && angle + rate * dt < low
        ? low
        : undefined;
  if (stop === undefined) return undefined;
  const bounce = joint.asked<number>('stopBounce');
  if (bounce > 0 && Math.abs(rate) > LEAST_BOUNCE) return -bounce * rate;
  const beyond = (stop - angle) * Math.sign(rate) < 0;
  return beyond ? 0 : (stop - angle) / dt;
}

/** Three rows that hold the anchor, two that hold the axis, and last the one about the axis. */
function rowsOf(joint: SingleAxisHingeJointNode): Row[] {
  const { p, q } = joint.worldFrame(1);
  const arm = (body: BodyNode | undefined): Vec3 =>
    body ? subtract(p, body.centerOfMassWorld()) : [0, 0, 0];
  const [arm1, arm2] = [arm(joint.body1), arm(joint.body2)];
  const axes: Vec3[] = [rotate(q, [1, 0, 0]), rotate(q, [0, 1, 0]), rotate(q, [0, 0, 1])];
  const held = axes.map((axis) => ({
    linear: axis,
    angular1: cross(arm1, axis),
    angular2: cross(arm2, axis),
  }));
  const turning = [axes[1]!, axes[2]!, axes[0]!].map((axis): Row => ({
    linear: [0, 0, 0],
    angular1: axis,
    angular2: axis,
  }));
  return [...held, ...turning];
}

/** J M⁻¹ Jᵀ of two rows. */
function coupling(joint: SingleAxisHingeJointNode, a: Row, b: Row): number {
  return (
    share(joint.body1, a.linear, a.angular1, b.linear, b.angular1) +
    share(joint.body2, a.linear, a.angular2, b.linear, b.angular2)
  );
}

function share(body: BodyNode | undefined, la: Vec3, wa: Vec3, lb: Vec3, wb: Vec3): number {
  if (!body?.movable) return 0;
  const { q } = compose(body.pose(), body.centerOfMass);
  const [x, y] = [rotate(conjugate(q), wa), rotate(conjugate(q), wb)];
  const [ix, iy, iz] = body.mass.moments;
  return (
    dot(la, lb) / body.mass.mass + (x[0] * y[0]) / ix + (x[1] * y[1]) / iy + (x[2] * y[2]) / iz
  );
}
