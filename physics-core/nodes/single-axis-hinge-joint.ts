import type { Stop } from '../effects/joints/stops.js';
import {
  between,
  FREE,
  JointNode,
  LOCKED,
  type JointFrame,
  type Limit,
  type RowCorrection,
} from './joint.js';
import { anchorFields, axisField, direction, jointFields, output } from './joint-fields.js';
import { angleStop, bounceField, correctionField, nearlyWhole } from './stop-fields.js';
import { defineNode } from './table.js';

/** The row about the frame's x. */
const ANGLE = 3;

export class SingleAxisHingeJointNode extends JointNode {
  stops: readonly Stop[] = [];

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

  protected override correctionOf(row: number): RowCorrection | undefined {
    return row === ANGLE ? { erp: this.asked('stopErrorCorrection') } : undefined;
  }

  updateStops(): void {
    this.updateLimits();
    this.updateCorrection();
    this.attachedChanged();
  }

  protected override zeroed(): void {
    this.stops = [];
  }

  protected override attachedChanged(): void {
    const [low, high] = this.#limit;
    const fields = {
      row: ANGLE,
      low,
      high,
      bounce: this.asked<number>('stopBounce'),
      correction: this.asked<number>('stopErrorCorrection'),
      softness: 0,
    };
    this.world.registry.stops.set(this, fields, 'minAngle, maxAngle');
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

const stops = (joint: SingleAxisHingeJointNode): void => joint.updateStops();

export const singleAxisHingeJoint = defineNode<SingleAxisHingeJointNode>({
  name: 'SingleAxisHingeJoint',
  containerField: 'joints',
  clause: '37.4.14',
  doc: 'Lets two bodies turn about one axis.',
  rank: 3,
  make: (context) => new SingleAxisHingeJointNode(context),
  fields: {
    ...jointFields,
    ...anchorFields,
    axis: axisField(
      [0, 1, 0],
      'Direction of the axis, world frame, when the joint is made. Editing it makes the joint anew.',
    ),
    minAngle: angleStop(
      -Math.PI,
      stops,
      'Lower stop, radians from the pose the joint was made at. Above maxAngle: no stops.',
    ),
    maxAngle: angleStop(Math.PI, stops, 'Upper stop, radians.'),
    stopBounce: bounceField(stops, 'Share of the turning speed that comes back from a stop.'),
    stopErrorCorrection: correctionField(
      0.8,
      stops,
      'Share of an overshoot past a stop repaired per 1/60 s.',
    ),
    angle: output((joint) => joint.angle, 'Angle of body1 relative to body2, radians in (-π, π].', {
      angle: 1,
    }),
    angleRate: output((joint) => joint.angleRate, 'Its rate, rad/s.', { angle: 1 }),
  },
});
