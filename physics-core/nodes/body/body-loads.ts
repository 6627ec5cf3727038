import { exp } from '../../base/exact/index.js';
import { add } from '../../base/math.js';
import type { Load } from '../../dynamics/body.js';
import { areEqualMoments } from '../../dynamics/moments.js';
import type { Vec3 } from '../../fields/types.js';
import type { BodyNode } from './body.js';

const NONE: Vec3 = [0, 0, 0];

/** What acts on a body in every step: gravity, its author's forces, damping. */
export class BodyLoads {
  readonly #node: BodyNode;
  /** The acceleration that Bullet gives it, m/s². */
  appliedGravity: Vec3 = NONE;
  /** Shares of its velocities that Bullet's damping takes per second. */
  dampedShare = { linear: 0, angular: 0 };
  constantLoad: Load = { force: NONE, torque: NONE };

  constructor(node: BodyNode) {
    this.#node = node;
  }

  /** Its own acceleration, m/s². */
  get gravity(): Vec3 {
    return this.#node.asked<boolean>('useGlobalGravity')
      ? this.#node.settings.asked('gravity')
      : NONE;
  }

  updateGravity(): void {
    if (!this.#node.built) return;
    this.applyGravity();
    this.#node.changed('gravity');
  }

  /** Bullet forgets it with each new mass, and whenever the body comes into the world. */
  applyGravity(): void {
    const { gravity } = this;
    if (!gravity.every((value, i) => value === this.appliedGravity[i])) {
      this.#node.motion.loadChanges();
      this.#node.wake();
    }
    this.appliedGravity = gravity;
    this.#node.world.bodies.review(this.#node);
    this.#node.body.setGravity(this.#node.world.engine.scratch.vector(...gravity));
  }

  updateForces(): void {
    const sum = (name: string): Vec3 =>
      this.#node.asked<Vec3[]>(name).reduce<Vec3>((total, value) => add(total, value), [0, 0, 0]);
    this.#node.motion.loadChanges();
    this.constantLoad = { force: sum('forces'), torque: sum('torques') };
    this.#node.changed('load');
    this.#node.wake();
  }

  get angularDamping(): number {
    return this.#node.asked<boolean>('autoDamp')
      ? this.#node.asked<number>('angularDampingFactor')
      : 0;
  }

  updateDamping(): void {
    this.applyDamping();
    this.#node.changed('damping');
  }

  /**
   * X3D's damping is a force, -factor × velocity, so mass matters. Bullet's is v·(1 - d)^dt, which is the exact solution
   * of that force for d = 1 - exp(-factor / mass). Of unequal moments an effect damps each axis by itself.
   */
  applyDamping(): void {
    const { mass, moments } = this.#node.mass;
    const on = this.#node.asked<boolean>('autoDamp');
    const linear = on ? 1 - exp(-this.#node.asked<number>('linearDampingFactor') / mass) : 0;
    const round = areEqualMoments(moments);
    const angular = round ? 1 - exp(-this.angularDamping / moments[0]) : 0;
    this.dampedShare = { linear: dampedShare(linear), angular: dampedShare(angular) };
    this.#node.body.setDamping(this.dampedShare.linear, this.dampedShare.angular);
  }
}

/** The most that single precision tells from all: nothing left would be no velocity to reckon with. */
const MOST_DAMPED = 1 - 2 ** -24;

/** As Bullet has it. */
const dampedShare = (value: number): number => Math.min(Math.fround(value), MOST_DAMPED);
