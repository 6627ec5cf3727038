import { joints } from '../../effects/effect/chunks.js';
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
import { anchorFields, axisField, jointFields, output } from './joint-fields.js';
import { angleStop, bounceField, correctionField, nearlyWhole } from './stop-fields.js';
import { defineNode } from '../node/define.js';

/** The row about the frame's x. */
const ANGLE = 3;

export class SingleAxisHingeJointNode extends JointNode {
  protected override wantedFrame(): JointFrame {
    return { anchor: this.asked('anchorPoint'), axis: joints.code.direction(this, 'axis') };
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

const stops = (joint: SingleAxisHingeJointNode): void => joint.updateRows();

export const singleAxisHingeJoint = defineNode<SingleAxisHingeJointNode>({
  name: 'SingleAxisHingeJoint',
  containerField: 'joints',
  clause: '37.4.14',
  doc: 'Lets two bodies turn about one axis.',
  rank: 3,
  chunk: joints,
  make: (context) => new SingleAxisHingeJointNode(context),
  fields: {
    ...jointFields,
    ...anchorFields,
    axis: axisField([0, 1, 0], {
      doc: 'Direction of the axis, world frame, when the joint is made. Editing it makes the joint anew.',
    }),
    minAngle: angleStop(-Math.PI, stops, {
      doc: 'Lower stop, radians from the pose the joint was made at. Above maxAngle: no stops.',
    }),
    maxAngle: angleStop(Math.PI, stops, { doc: 'Upper stop, radians.' }),
    stopBounce: bounceField(stops, {
      doc: 'Share of the turning speed that comes back from a stop.',
    }),
    stopErrorCorrection: correctionField(0.8, stops, {
      doc: 'Share of an overshoot past a stop repaired per 1/60 s.',
    }),
    angle: output(
      (joint) => joint.angle,
      { doc: 'Angle of body1 relative to body2, radians in (-π, π].' },
      {
        angle: 1,
      },
    ),
    angleRate: output((joint) => joint.angleRate, { doc: 'Its rate, rad/s.' }, { angle: 1 }),
  },
});
