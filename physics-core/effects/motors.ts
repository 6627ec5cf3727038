import type { JointNode } from '../nodes/joint.js';
import type { World } from '../world/world.js';
import { Effect } from './effect.js';

/** A motor on one row of a joint. */
export interface Motor {
  row: number;
  /** The rate it strives for, rad/s or m/s, body1 against body2. */
  target: number;
  /** What it can muster, N m or N. */
  most: number;
}

/** Joints with motors. `push`: torques and forces that heed no rate. */
interface Driven extends JointNode {
  readonly motors?: readonly Motor[];
  push?(dt: number): void;
}

/** What drives joints: torques, forces, and motors that bring a row to a rate with what they can muster. */
export class Motors extends Effect {
  readonly name = 'motors';
  readonly #world: World;

  constructor(world: World) {
    super();
    this.#world = world;
  }

  override beforeStep(dt: number): void {
    for (const node of this.causes) {
      const joint = node as Driven;
      joint.push?.(dt);
      if (joint.motors) this.#drive(joint, joint.motors, dt);
    }
  }

  /** The impulse that gives the wanted rate after the step, with the forces of the step counted in. */
  #drive(joint: Driven, motors: readonly Motor[], dt: number): void {
    const { rows } = this.#world.registry;
    if (!rows.read(joint, dt)) return;
    for (const { row, target, most } of motors) {
      rows.look(row);
      const wanted = (target - rows.coming) / rows.ease;
      rows.push(row, Math.max(-most * dt, Math.min(most * dt, wanted)));
    }
  }
}
