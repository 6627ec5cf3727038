import type { Vec3 } from '../fields/types.js';
import { add, normalize, rotate, scale, type Pose } from '../math.js';
import { FREE, JointNode, type JointFrame, type Limit } from './joint.js';
import { jointFields } from './joint-fields.js';
import { defineNode, type Field } from './table.js';

/** Turns bodies against each other about up to three axes. It holds nothing together: that takes another joint. */
export class MotorJointNode extends JointNode {
  /** The motor's axes as body1 (or the world, without it) carries them. */
  #axes: Vec3[] = [];

  protected override wantedFrame(): JointFrame {
    return { anchor: (this.body1 ?? this.body2)!.pose().p };
  }

  protected override linearLimits(): [Limit, Limit, Limit] {
    return [FREE, FREE, FREE];
  }

  protected override angularLimits(): [Limit, Limit, Limit] {
    return [FREE, FREE, FREE];
  }

  protected override attachedChanged(): void {
    if (this.attached) this.updateAxes();
    else this.world.registry.motors.drop(this);
  }

  /** Axes are world directions when they are set, and turn with body1 from then on (X3D 37.4.10, user mode). */
  updateAxes(): void {
    const carrier = this.body1?.built ? this.body1.pose().q : undefined;
    this.#axes = [1, 2, 3].map((n) => {
      const axis = normalize(this.asked<Vec3>(`motor${n}Axis`), [0, 0, 0]);
      return carrier ? rotate([-carrier[0], -carrier[1], -carrier[2], carrier[3]], axis) : axis;
    });
    this.updateTorque();
  }

  updateTorque(): void {
    const { motors } = this.world.registry;
    const driven = this.#torques().findIndex((torque) => torque !== 0);
    if (!this.attached || driven < 0) motors.drop(this);
    else motors.need(this, `axis${driven + 1}Torque`);
    for (const body of [this.body1, this.body2]) body?.wake();
  }

  /** Torques about the axes that `enabledAxes` (a count) covers. */
  #torques(): number[] {
    const enabled = this.asked<number>('enabledAxes');
    return [1, 2, 3].map((n) => (n <= enabled ? this.asked<number>(`axis${n}Torque`) : 0));
  }

  /** Newton metres on body1, world frame. */
  torque(): Vec3 {
    const carrier: Pose['q'] = this.body1 ? this.body1.pose().q : [0, 0, 0, 1];
    return this.#torques().reduce<Vec3>(
      (sum, torque, i) => (torque ? add(sum, scale(rotate(carrier, this.#axes[i]!), torque)) : sum),
      [0, 0, 0],
    );
  }
}

const axes = (joint: MotorJointNode): void => joint.updateAxes();
const torque = (joint: MotorJointNode): void => joint.updateTorque();

const axis = (n: number, value: Vec3): Field<MotorJointNode> => ({
  type: 'SFVec3f',
  access: 'inputOutput',
  default: value,
  edit: 'live',
  patch: axes,
  doc: `Direction of axis ${n}, world frame when it is set; it turns with body1.`,
});
const torqueAbout = (n: number): Field<MotorJointNode> => ({
  type: 'SFFloat',
  access: 'inputOutput',
  default: 0,
  dimension: { force: 1, length: 1 },
  edit: 'live',
  patch: torque,
  doc: `Torque about axis ${n}, newton metres: plus on body1, minus on body2.`,
});

export const motorJoint = defineNode<MotorJointNode>({
  name: 'MotorJoint',
  containerField: 'joints',
  clause: '37.4.10',
  doc: 'Turns two bodies against each other by torques about up to three axes.',
  rank: 3,
  make: (context) => new MotorJointNode(context),
  fields: {
    ...jointFields,
    enabledAxes: {
      type: 'SFInt32',
      access: 'inputOutput',
      default: 1,
      range: [0, 3],
      edit: 'live',
      patch: torque,
      doc: 'How many axes are driven: 0 to 3.',
    },
    motor1Axis: axis(1, [1, 0, 0]),
    motor2Axis: axis(2, [0, 1, 0]),
    motor3Axis: axis(3, [0, 0, 1]),
    axis1Torque: torqueAbout(1),
    axis2Torque: torqueAbout(2),
    axis3Torque: torqueAbout(3),
  },
});
