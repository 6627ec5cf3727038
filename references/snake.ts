import type { World } from '../physics-core/inside.js';
import type { BodyNode } from '../physics-core/nodes/body/body.js';
import type { JointNode } from '../physics-core/nodes/joints/joint.js';

/** Metres from hinge to hinge. */
const LINK = 0.5;

/** Scene 4 of the paper: a chain on the ground that grows by one hinged piece a frame, pushed to and fro. */
export class Snake {
  readonly joints: JointNode[] = [];
  readonly #world: World;
  readonly #pieces: number;
  #last: BodyNode;

  constructor(world: World, pieces: number) {
    this.#world = world;
    this.#pieces = pieces;
    const ground = { type: 'Box', size: [4 * pieces, 1, 4 * pieces] };
    world.add('RigidBody', { fixed: true, position: [0, -0.5, 0], geometry: [ground] });
    this.#last = this.#piece({ fixed: true, position: [0, 0.1, 0] });
  }

  #piece(fields: object): BodyNode {
    const geometry = [{ type: 'Box', size: [0.4, 0.2, 0.2] }];
    return this.#world.add('RigidBody', { mass: 0.5, geometry, ...fields }) as BodyNode;
  }

  grow(): void {
    if (this.joints.length >= this.#pieces) return;
    const before = this.#last;
    const [x, y, z] = before.get('position') as [number, number, number];
    const [, turn, , angle] = before.get('orientation') as [number, number, number, number];
    const heading = angle * Math.sign(turn || 1);
    const [along, across] = [Math.cos(heading), -Math.sin(heading)];
    const at = (way: number, height: number) => [x + way * along, height, z + way * across];
    this.#last = this.#piece({
      position: at(LINK, 0.1),
      orientation: [0, 1, 0, heading],
      linearVelocity: [0, 0, this.joints.length % 2 ? 0.5 : -0.5],
    });
    const bodies = { body1: before, body2: this.#last };
    const fields = { ...bodies, axis: [0, 1, 0], anchorPoint: at(LINK / 2, y) };
    this.joints.push(this.#world.add('SingleAxisHingeJoint', fields) as JointNode);
  }

  get length(): number {
    return LINK * this.joints.length;
  }

  /** The sum of all. */
  get gaps(): number {
    return this.joints.reduce((sum, joint) => sum + joint.gap, 0);
  }
}
