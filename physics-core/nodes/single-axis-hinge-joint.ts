import { conjugate, dot, multiply, subtract, length } from '../math.js';
import type { Vec3 } from '../fields/types.js';
import { FREE, JointNode, LOCKED, type JointFrame, type Limit } from './joint.js';
import { anchorFields, jointFields, rezeroPatch } from './joint-fields.js';
import { defineNode } from './table.js';

/** Stops this near to a full turn count as none: the angle itself jumps there from one end to the other. */
const NEARLY_PI = Math.PI - 1e-4;

export class SingleAxisHingeJointNode extends JointNode {
  protected override wantedFrame(): JointFrame {
    return { anchor: this.asked('anchorPoint'), axis: this.axis() };
  }

  /** A zero axis (the default before X3D 4.0) means the default of X3D 4.0. */
  private axis(): Vec3 {
    const axis = this.asked<Vec3>('axis');
    if (length(axis) > 1e-9) {
      this.world.settle(this, 'axis', 'bad-value');
      return axis;
    }
    this.report({
      code: 'bad-value',
      severity: 'warning',
      attribute: 'axis',
      value: axis,
      used: [0, 1, 0],
      message: `${this.label}: axis="0 0 0" has no direction; 0 1 0 is used`,
    });
    return [0, 1, 0];
  }

  /** Stops of the angle; none where min is above max or both lie a full turn apart. */
  get stops(): Limit {
    const [low, high] = [this.asked<number>('minAngle'), this.asked<number>('maxAngle')];
    return low > high || (low <= -NEARLY_PI && high >= NEARLY_PI)
      ? FREE
      : low === high
        ? [low, low + 1e-6]
        : [low, high];
  }

  protected override linearLimits(): [Limit, Limit, Limit] {
    return [LOCKED, LOCKED, LOCKED];
  }

  protected override angularLimits(): [Limit, Limit, Limit] {
    return [this.stops, LOCKED, LOCKED];
  }

  protected override stopCorrection(): number {
    return this.asked('stopErrorCorrection');
  }

  updateStops(): void {
    this.updateLimits();
    this.updateCorrection();
    this.attachedChanged();
  }

  protected override attachedChanged(): void {
    const { stops } = this.world.registry;
    if (this.attached && this.stops[0] <= this.stops[1]) stops.need(this, 'minAngle, maxAngle');
    else stops.drop(this);
  }

  /** Turn of body1 relative to body2 about the axis, radians in (-π, π]. */
  get angle(): number {
    const relative = multiply(conjugate(this.worldFrame(2).q), this.worldFrame(1).q);
    const angle = 2 * Math.atan2(relative[0], relative[3]);
    return angle > Math.PI ? angle - 2 * Math.PI : angle <= -Math.PI ? angle + 2 * Math.PI : angle;
  }

  /** rad/s. */
  get angleRate(): number {
    return dot(
      subtract(this.angularVelocityOf(this.body1), this.angularVelocityOf(this.body2)),
      this.axisWorld(),
    );
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
    axis: {
      type: 'SFVec3f',
      access: 'inputOutput',
      default: [0, 1, 0],
      edit: 'live',
      patch: rezeroPatch,
      doc: 'Direction of the axis, world frame, when the joint is made. Editing it makes the joint anew.',
    },
    minAngle: {
      type: 'SFFloat',
      access: 'inputOutput',
      default: -Math.PI,
      range: [-Math.PI, Math.PI],
      dimension: { angle: 1 },
      edit: 'live',
      patch: stops,
      doc: 'Lower stop, radians from the pose the joint was made at. Above maxAngle: no stops.',
    },
    maxAngle: {
      type: 'SFFloat',
      access: 'inputOutput',
      default: Math.PI,
      range: [-Math.PI, Math.PI],
      dimension: { angle: 1 },
      edit: 'live',
      patch: stops,
      doc: 'Upper stop, radians.',
    },
    stopBounce: {
      type: 'SFFloat',
      access: 'inputOutput',
      default: 0,
      range: [0, 1],
      edit: 'live',
      patch: stops,
      doc: 'Share of the turning speed that comes back from a stop.',
    },
    stopErrorCorrection: {
      type: 'SFFloat',
      access: 'inputOutput',
      default: 0.8,
      range: [0, 1],
      edit: 'live',
      patch: stops,
      doc: 'Share of an overshoot past a stop repaired per 1/60 s.',
    },
    angle: {
      type: 'SFFloat',
      access: 'outputOnly',
      default: 0,
      dimension: { angle: 1 },
      edit: 'passive',
      read: (joint) => joint.angle,
      doc: 'Angle of body1 relative to body2, radians.',
    },
    angleRate: {
      type: 'SFFloat',
      access: 'outputOnly',
      default: 0,
      dimension: { angle: 1 },
      edit: 'passive',
      read: (joint) => joint.angleRate,
      doc: 'Its rate, rad/s.',
    },
  },
});
