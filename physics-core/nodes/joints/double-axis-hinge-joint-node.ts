import { asin } from '../../base/exact/asin.js';
import { direction, notAlong } from '../../effects/joints/axes.js';
import type { Motor, Stop } from '../../dynamics/joint.js';
import { FRAME, softnessAtStep } from '../../dynamics/levels.js';
import type { Vec3 } from '../../fields/types.js';
import { dot } from '../../base/math.js';
import {
  between,
  FREE,
  JointNode,
  LOCKED,
  type JointFrame,
  type Limit,
  type OwnCorrection,
} from './joint.js';
import { nearlyWhole } from './stop-fields.js';

/** Rows: along axis1 (z of body1's frame), about axis2 (x of body2's), and about axis1. */
const ALONG = 2;
const SPIN = 3;
const STEER = 5;

/** Bullet's solver comes to a row this soft (in its own terms) within its iterations; softer ones it overshoots. */
const SOFTEST_ROW = 0.5;

/** The wheel of a car: body1 steers about axis1, which is also the strut of its suspension; body2 spins about axis2. */
export class DoubleAxisHingeJointNode extends JointNode {
  /** Angle between the axes beyond a right one, which they keep. */
  #skew = 0;

  protected override wantedFrame(): JointFrame {
    return { anchor: this.asked('anchorPoint'), axes: this.#axes() };
  }

  protected override get slides(): boolean {
    return true;
  }

  #axes(): readonly [Vec3, Vec3] {
    const axis1 = direction(this, 'axis1');
    return [axis1, notAlong(this, axis1, 'axis2')];
  }

  protected override zeroed(): void {
    this.#skew = asin(dot(...this.#axes()));
  }

  /** axis1 is z of body1's frame, so body1 is Bullet's A. */
  protected override shouldSwap(): boolean {
    return false;
  }

  // ---- rows ---------------------------------------------------------------------------------------------------------

  /** None where min is above max or both lie a full turn apart. */
  get #steering(): Limit {
    const [low, high] = [this.asked<number>('minAngle1'), this.asked<number>('maxAngle1')];
    return nearlyWhole(low, high) ? FREE : between(low, high);
  }

  /** Stops that give way are left to the effect: Bullet's own would add to them. */
  get #softStops(): boolean {
    const [low, high] = this.#steering;
    return low < high && this.asked<number>('stop1ConstantForceMix') > 0;
  }

  protected override linearLimits(): [Limit, Limit, Limit] {
    return [LOCKED, LOCKED, this.spring ? FREE : LOCKED];
  }

  protected override angularLimits(): [Limit, Limit, Limit] {
    return [FREE, between(this.#skew, this.#skew), this.#softStops ? FREE : this.#steering];
  }

  protected override correctionOf(row: number): OwnCorrection | undefined {
    const give = this.asked<number>('suspensionForce');
    if (row === ALONG && give > 0)
      return { erp: this.asked('suspensionErrorCorrection'), softness: give };
    if (row !== STEER) return undefined;
    return {
      erp: this.asked('stop1ErrorCorrection'),
      softness: this.asked('stop1ConstantForceMix'),
    };
  }

  // ---- suspension ---------------------------------------------------------------------------------------------------

  /**
   * X3D gives the strut as the softness and error correction of a constraint solved every 1/60 s; that is a spring and
   * a damper. A stiff one stays a row of Bullet's solver, which is stable however stiff; one that is too soft for the
   * solver's iterations becomes a force.
   */
  protected override chooseRows(): void {
    const give = this.asked<number>('suspensionForce');
    const share = this.asked<number>('suspensionErrorCorrection');
    const { solver } = this.world;
    const { jointRows: rows } = this;
    const { stepSeconds } = solver;
    rows.fill(this, stepSeconds);
    const softness =
      softnessAtStep(give, share, stepSeconds) / (stepSeconds * rows.between(ALONG, ALONG));
    const springs = give > 0 && softness > SOFTEST_ROW;
    this.spring = springs
      ? { row: ALONG, stiffness: share / (FRAME * give), damping: (1 - share) / give }
      : undefined;
  }

  // ---- stops and motors ---------------------------------------------------------------------------------------------

  protected override wantedStops(): readonly Stop[] {
    const [low, high] = this.#steering;
    return this.stopAt({
      row: STEER,
      low,
      high,
      bounce: this.asked('stop1Bounce'),
      correction: this.asked('stop1ErrorCorrection'),
      softness: this.asked('stop1ConstantForceMix'),
      axis: 1,
      reason: 'minAngle1, maxAngle1',
    });
  }

  /** A motor about an axis that is held turns nothing. */
  protected override wantedMotors(): readonly Motor[] {
    return ([1, 2] as const)
      .map((n) => ({
        row: n === 1 ? STEER : SPIN,
        target: this.asked<number>(`desiredAngularVelocity${n}`),
        most: this.asked<number>(`maxTorque${n}`),
      }))
      .filter(({ row, most }) => most > 0 && !this.lockedRows.includes(row));
  }

  /** The speed of a motor without torque is nothing to the effects. */
  override updateMotors(): void {
    if (this.motors.length > 0 || this.wantedMotors().length > 0) super.updateMotors();
    else this.wakeBodies();
  }

  // ---- outputs ------------------------------------------------------------------------------------------------------

  /** Turn of body1 against body2 about axis 1 or 2, radians in (-π, π]. */
  hingeAngle(n: 1 | 2): number {
    return this.valueOf(n === 1 ? STEER : SPIN);
  }

  /** rad/s. */
  hingeAngleRate(n: 1 | 2): number {
    return this.rateOf(n === 1 ? STEER : SPIN);
  }
}
