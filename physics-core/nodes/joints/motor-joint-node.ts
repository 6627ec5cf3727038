import { reportAxis } from '../../effects/joints/axes.js';
import { reportIdle } from '../../effects/joints/joint-reports.js';
import type { Vec3 } from '../../fields/types.js';
import { add, cross, dot, length, normalize, rotate, scale, subtract } from '../../base/math.js';
import { FREE, JointNode, type JointFrame, type Limit } from './joint.js';

/** Row of the angle about each axis in Euler mode, and whether it counts the other way round. */
const EULER = [
  { row: 5, sign: 1 },
  { row: 4, sign: -1 },
  { row: 3, sign: 1 },
] as const;

export type AxisNumber = 1 | 2 | 3;
const AXES: readonly AxisNumber[] = [1, 2, 3];
const NOWHERE: Vec3 = [0, 0, 0];

/** Cosine, or sine, of the angle between two axes up to which they count as at right angles, or as one. */
const SKEW = 1e-4;

/** z and x of frames along the world's axes. */
const WORLD_AXES = [
  [0, 0, 1],
  [1, 0, 0],
] as const satisfies readonly [Vec3, Vec3];

/**
 * Turns bodies against each other about up to three axes. It holds nothing together: that takes another joint. In user
 * mode body1 carries all axes; in Euler mode (`autoCalc`) it carries the first, body2 the third, and the second is at
 * right angles to both.
 */
export class MotorJointNode extends JointNode {
  get #euler(): boolean {
    return this.asked<boolean>('autoCalc');
  }

  #asked(n: AxisNumber): Vec3 {
    return normalize(this.asked<Vec3>(`motor${n}Axis`), NOWHERE);
  }

  protected override wantedFrame(): JointFrame {
    const anchor = (this.body1 ?? this.body2)!.pose().p;
    const across = this.#euler ? this.#across() : NOWHERE;
    return { anchor, axes: this.#euler && this.#turns ? [this.#asked(1), across] : WORLD_AXES };
  }

  /** The third axis, made to stand at right angles to the first. */
  #across(): Vec3 {
    const [first, third] = [this.#asked(1), this.#asked(3)];
    const along = dot(first, third);
    const skew = Math.abs(along) >= SKEW;
    const used = skew ? normalize(subtract(third, scale(first, along)), NOWHERE) : third;
    reportAxis(this, skew, {
      attribute: 'motor3Axis',
      used,
      why: 'has to stand at right angles to motor1Axis where autoCalc is',
    });
    return used;
  }

  /** Axes 1 and 3 have directions of their own, which Euler angles need. */
  get #turns(): boolean {
    return length(cross(this.#asked(1), this.#asked(3))) > SKEW;
  }

  protected override shouldSwap(): boolean {
    return false;
  }

  protected override linearLimits(): [Limit, Limit, Limit] {
    return [FREE, FREE, FREE];
  }

  protected override angularLimits(): [Limit, Limit, Limit] {
    return [FREE, FREE, FREE];
  }

  // ---- axes ---------------------------------------------------------------------------------------------------------

  /** Where an axis points now, world frame. */
  #axis(n: AxisNumber): Vec3 {
    if (!this.#euler) return rotate(this.worldFrame(1).q, this.#asked(n));
    if (!this.#turns) return this.#alone(n);
    const [first, third] = [this.axisOn(1, 2), this.axisOn(2, 0)];
    return n === 1 ? first : n === 3 ? third : normalize(cross(third, first), NOWHERE);
  }

  /** Where the first and the third have no second between them, each still turns what it is carried by. */
  #alone(n: AxisNumber): Vec3 {
    return n === 2 ? NOWHERE : rotate(this.worldFrame(n === 1 ? 1 : 2).q, this.#asked(n));
  }

  // ---- torque -------------------------------------------------------------------------------------------------------

  override get drivenBy(): string | undefined {
    const driven = AXES.find((n) => this.#torque(n) !== 0);
    return driven && `axis${driven}Torque`;
  }

  reportIdle(): void {
    reportIdle(this);
  }

  /** About an axis that `enabledAxes` (a count) covers. */
  #torque(n: AxisNumber): number {
    return n <= this.asked<number>('enabledAxes') ? this.asked<number>(`axis${n}Torque`) : 0;
  }

  /** Plus on body1, minus on body2. */
  override push(): void {
    const { scratch } = this.world.engine;
    const torque = AXES.reduce<Vec3>(
      (sum, n) => (this.#torque(n) ? add(sum, scale(this.#axis(n), this.#torque(n))) : sum),
      NOWHERE,
    );
    for (const [body, sign] of [
      [this.body1, 1],
      [this.body2, -1],
    ] as const)
      if (body?.active && body.movable && !body.sleeping)
        body.body.applyTorque(scratch.vector(...scale(torque, sign)));
  }

  // ---- outputs ------------------------------------------------------------------------------------------------------

  /** Radians: measured in Euler mode, what the author told in user mode. */
  motorAngle(n: AxisNumber): number {
    if (!this.#euler) return this.asked(`axis${n}Angle`);
    const { row, sign } = EULER[n - 1]!;
    return this.#turns ? sign * this.valueOf(row) : 0;
  }

  /** rad/s. */
  motorAngleRate(n: AxisNumber): number {
    if (!this.placed) return 0;
    if (!this.#euler) return dot(this.relativeSpin(), this.#axis(n));
    const { row, sign } = EULER[n - 1]!;
    return this.#turns ? sign * this.rateOf(row) : 0;
  }
}
