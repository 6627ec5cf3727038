import { direction, notAlong, reportAxis } from '../../effects/joints/axes.js';
import type { Vec3 } from '../../fields/types.js';
import { dot, normalize, scale, subtract } from '../../base/math.js';
import { FREE, JointNode, LOCKED, type JointFrame, type Limit } from './joint.js';

/** Cosine of the angle between the axes up to which they count as at right angles. */
const SKEW = 1e-4;

/** Two bodies on the cross of a cardan shaft: each turns about its own arm, and the arms stay at right angles. */
export class UniversalJointNode extends JointNode {
  protected override wantedFrame(): JointFrame {
    const axis1 = direction(this, 'axis1');
    return { anchor: this.asked('anchorPoint'), axes: [axis1, this.#axis2(axis1)] };
  }

  #axis2(axis1: Vec3): Vec3 {
    const axis2 = notAlong(this, axis1, 'axis2');
    const cosine = dot(axis1, axis2);
    if (Math.abs(cosine) <= SKEW) return axis2;
    const used = normalize(subtract(axis2, scale(axis1, cosine)));
    reportAxis(this, true, {
      attribute: 'axis2',
      used,
      why: 'is not at right angles to axis1',
    });
    return used;
  }

  /** axis1 is z of body1's frame, so body1 is Bullet's A. */
  protected override shouldSwap(): boolean {
    return false;
  }

  protected override linearLimits(): [Limit, Limit, Limit] {
    return [LOCKED, LOCKED, LOCKED];
  }

  protected override angularLimits(): [Limit, Limit, Limit] {
    return [FREE, LOCKED, FREE];
  }
}
