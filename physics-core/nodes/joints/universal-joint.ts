import { joints } from '../../effects/effect/chunks.js';
import type { Vec3 } from '../../fields/types.js';
import { dot, normalize, scale, subtract } from '../../base/math.js';
import { FREE, JointNode, LOCKED, type JointFrame, type Limit } from './joint.js';
import { anchorFields, axisField, axisOutput, jointFields } from './joint-fields.js';
import { idleStop } from './stop-fields.js';
import { defineNode } from '../node/define.js';

/** Cosine of the angle between the axes up to which they count as at right angles. */
const SKEW = 1e-4;

/** Two bodies on the cross of a cardan shaft: each turns about its own arm, and the arms stay at right angles. */
export class UniversalJointNode extends JointNode {
  protected override wantedFrame(): JointFrame {
    const axis1 = joints.code.direction(this, 'axis1');
    return { anchor: this.asked('anchorPoint'), axes: [axis1, this.#axis2(axis1)] };
  }

  #axis2(axis1: Vec3): Vec3 {
    const axis2 = joints.code.notAlong(this, axis1, 'axis2');
    const cosine = dot(axis1, axis2);
    if (Math.abs(cosine) <= SKEW) return axis2;
    const used = normalize(subtract(axis2, scale(axis1, cosine)));
    joints.code.reportAxis(this, true, {
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

export const universalJoint = defineNode<UniversalJointNode>({
  name: 'UniversalJoint',
  containerField: 'joints',
  clause: '37.4.16',
  doc: 'A cardan joint: turns one body with the other round a bend.',
  rank: 3,
  chunk: joints,
  make: (context) => new UniversalJointNode(context),
  fields: {
    ...jointFields,
    ...anchorFields,
    axis1: axisField([1, 0, 0], {
      doc: 'First arm of the cross, world frame, when the joint is made; body1 carries it. Editing it makes the joint anew.',
    }),
    axis2: axisField([0, 1, 0], {
      doc: 'Second arm, at right angles to the first, world frame, when the joint is made; body2 carries it. Editing it makes the joint anew.',
    }),
    stop1Bounce: idleStop(1, 'Bounce'),
    stop1ErrorCorrection: idleStop(1, 'ErrorCorrection'),
    stop2Bounce: idleStop(2, 'Bounce'),
    stop2ErrorCorrection: idleStop(2, 'ErrorCorrection'),
    body1Axis: axisOutput(1, 2),
    body2Axis: axisOutput(2, 0),
  },
});
