import { joints } from '../../effects/effect/chunks.js';
import { FREE, JointNode, LOCKED, type JointFrame } from './joint.js';
import { anchorFields, jointFields } from './joint-fields.js';
import { defineNode } from '../node/define.js';

export class BallJointNode extends JointNode {
  protected override wantedFrame(): JointFrame {
    return { anchor: this.asked('anchorPoint') };
  }

  protected override linearLimits() {
    return [LOCKED, LOCKED, LOCKED] as [typeof LOCKED, typeof LOCKED, typeof LOCKED];
  }

  protected override angularLimits() {
    return [FREE, FREE, FREE] as [typeof FREE, typeof FREE, typeof FREE];
  }
}

export const ballJoint = defineNode<BallJointNode>({
  name: 'BallJoint',
  containerField: 'joints',
  clause: '37.4.1',
  doc: 'Holds a point of both bodies together and lets them turn about it.',
  rank: 3,
  chunk: joints,
  make: (context) => new BallJointNode(context),
  fields: { ...jointFields, ...anchorFields },
});
