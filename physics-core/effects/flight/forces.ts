import type { Vec3 } from '../../fields/types.js';
import { add } from '../../base/math.js';
import type { MovingNode } from '../../nodes/body-motion.js';
import type { PhysicsNode } from '../../nodes/node.js';
import type { World } from '../../world/world.js';
import { Effect } from '../effect.js';

export interface Load {
  force: Vec3;
  torque: Vec3;
}

const NONE: Load = { force: [0, 0, 0], torque: [0, 0, 0] };

const isZero = (v: Vec3): boolean => v[0] === 0 && v[1] === 0 && v[2] === 0;

/** RigidBody.forces and torques in every step, and what `applyForce` and `applyTorque` ask for the next one. */
export class AuthoredForces extends Effect {
  readonly name = 'forces';
  readonly #world: World;
  readonly #constant = new Map<MovingNode, Load>();
  readonly #once = new Map<MovingNode, Load>();

  constructor(world: World) {
    super();
    this.#world = world;
  }

  set(body: MovingNode, force: Vec3, torque: Vec3): void {
    if (isZero(force) && isZero(torque)) {
      this.#constant.delete(body);
      if (!this.#once.has(body)) super.drop(body);
      return;
    }
    this.#constant.set(body, { force, torque });
    this.need(body, isZero(force) ? 'torques' : 'forces');
  }

  push(body: MovingNode, force: Vec3, torque: Vec3): void {
    const before = this.#once.get(body) ?? { force: [0, 0, 0], torque: [0, 0, 0] };
    this.#once.set(body, { force: add(before.force, force), torque: add(before.torque, torque) });
    if (!this.#constant.has(body)) this.need(body, 'applyForce');
  }

  /** What acts in every step. */
  constant(body: MovingNode): Load {
    return this.#constant.get(body) ?? NONE;
  }

  /** What waits for the next step. */
  pending(body: MovingNode): Load | undefined {
    return this.#once.get(body);
  }

  override drop(node: PhysicsNode): void {
    this.#constant.delete(node as MovingNode);
    this.#once.delete(node as MovingNode);
    super.drop(node);
  }

  override beforeStep(): void {
    for (const [body, load] of this.#constant) this.#apply(body, load);
    for (const [body, load] of this.#once) this.#apply(body, load);
  }

  #apply(body: MovingNode, { force, torque }: Load): void {
    if (!body.active || !body.movable || body.sleeping) return;
    const { scratch } = this.#world.engine;
    body.body.applyCentralForce(scratch.vector(...force));
    body.body.applyTorque(scratch.vector(...torque));
  }

  /** What was asked for one step is spent. */
  override afterStep(): void {
    for (const body of this.#once.keys()) if (!this.#constant.has(body)) super.drop(body);
    this.#once.clear();
  }
}
