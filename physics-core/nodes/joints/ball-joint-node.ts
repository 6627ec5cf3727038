import { FREE, JointNode, LOCKED, type JointFrame } from './joint.js';

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
