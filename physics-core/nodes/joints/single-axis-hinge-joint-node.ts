import { direction } from '../../effects/joints/axes.js';
import type { Stop } from '../../dynamics/joint.js';
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

/** The row about the frame's x. */
const ANGLE = 3;

export class SingleAxisHingeJointNode extends JointNode {
  protected override wantedFrame(): JointFrame {
    return { anchor: this.asked('anchorPoint'), axis: direction(this, 'axis') };
  }

  /** Stops of the angle; none where min is above max or both lie a full turn apart. */
  get #limit(): Limit {
    const [low, high] = [this.asked<number>('minAngle'), this.asked<number>('maxAngle')];
    return nearlyWhole(low, high) ? FREE : between(low, high);
  }

  protected override linearLimits(): [Limit, Limit, Limit] {
    return [LOCKED, LOCKED, LOCKED];
  }

  protected override angularLimits(): [Limit, Limit, Limit] {
    return [this.#limit, LOCKED, LOCKED];
  }

  protected override correctionOf(row: number): OwnCorrection | undefined {
    return row === ANGLE ? { erp: this.asked('stopErrorCorrection') } : undefined;
  }

  protected override wantedStops(): readonly Stop[] {
    const [low, high] = this.#limit;
    return this.stopAt({
      row: ANGLE,
      low,
      high,
      bounce: this.asked('stopBounce'),
      correction: this.asked('stopErrorCorrection'),
      softness: 0,
      reason: 'minAngle, maxAngle',
    });
  }

  /** Turn of body1 relative to body2 about the axis, radians in (-π, π]. */
  get angle(): number {
    return this.valueOf(ANGLE);
  }

  /** rad/s. */
  get angleRate(): number {
    return this.rateOf(ANGLE);
  }
}
