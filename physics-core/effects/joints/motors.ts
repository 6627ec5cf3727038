import type { JointNode } from '../../nodes/joint.js';
import type { PhysicsNode } from '../../nodes/node.js';
import type { World } from '../../world/world.js';
import { Effect } from '../effect.js';

/** A motor on one row of a joint. */
export interface Motor {
  row: number;
  /** The rate it strives for, rad/s or m/s, body1 against body2. */
  target: number;
  /** What it can muster, N m or N. */
  most: number;
}

/** Joints that are driven. `push`: torques and forces that heed no rate. */
interface Driven extends JointNode {
  push?(dt: number): void;
}

/** Torques and forces between the bodies of joints. Motors that heed a rate are rows of the joint solve. */
export class Motors extends Effect {
  readonly name = 'motors';
  readonly #world: World;

  constructor(world: World) {
    super();
    this.#world = world;
  }

  override need(node: PhysicsNode, reason: string): void {
    super.need(node, reason);
    this.#world.registry.joints.update(node as JointNode);
  }

  override drop(node: PhysicsNode): void {
    if (!this.isNeededBy(node)) return;
    super.drop(node);
    this.#world.registry.joints.update(node as JointNode);
  }

  override beforeStep(dt: number): void {
    for (const node of this.causes) (node as Driven).push?.(dt);
  }
}
