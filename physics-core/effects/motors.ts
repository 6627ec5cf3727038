import type { MotorJointNode } from '../nodes/motor-joint.js';
import type { World } from '../world/world.js';
import { scale } from '../math.js';
import { Effect } from './effect.js';

/** MotorJoint torques: plus on body1, minus on body2, in every step. */
export class Motors extends Effect {
  readonly name = 'motors';
  readonly #world: World;

  constructor(world: World) {
    super();
    this.#world = world;
  }

  override beforeStep(): void {
    const { scratch } = this.#world.engine;
    for (const node of this.causes) {
      const joint = node as MotorJointNode;
      const { body1, body2 } = joint;
      const torque = joint.torque();
      if (body1?.active && body1.movable && !body1.sleeping)
        body1.body.applyTorque(scratch.vector(...torque));
      if (body2?.active && body2.movable && !body2.sleeping)
        body2.body.applyTorque(scratch.vector(...scale(torque, -1)));
    }
  }
}
