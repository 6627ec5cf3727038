import { BOUNDS, shownBound } from '../../fields/bounds.js';
import { guards } from '../../base/guards.js';
import { cross, quaternionOf, rotationOf, subtract } from '../../base/math.js';
import { show } from '../../base/show.js';
import { forces } from '../../effects/flight/forces.js';
import type { Rotation, Vec3 } from '../../fields/types.js';
import { codecs } from '../../fields/values.js';
import type { BodyNode } from './body.js';

/** World frame, m/s and rad/s. */
export interface Velocities {
  linearVelocity: Vec3;
  angularVelocity: Vec3;
}

/** What page code may do to a body at once: it is heeded only where all that is handed over can be. */
export class BodyCommands {
  readonly #node: BodyNode;

  constructor(node: BodyNode) {
    this.#node = node;
  }

  teleport(
    position: Vec3,
    orientation: Rotation | undefined,
    velocities: Partial<Velocities>,
  ): void {
    const node = this.#node;
    node.world.flush();
    const given = <T>(type: 'SFVec3f' | 'SFRotation', value: unknown, now: T): T | undefined =>
      value === undefined ? now : this.argument<T>('teleport', type, value);
    if (!node.built) return;
    node.motion.loadChanges();
    const { linear, angular } = node.velocityAtOrigin();
    const p = this.argument<Vec3>('teleport', 'SFVec3f', position);
    const rotation = given('SFRotation', orientation, rotationOf(node.pose().q));
    const after = {
      linear: given('SFVec3f', velocities?.linearVelocity, linear),
      angular: given('SFVec3f', velocities?.angularVelocity, angular),
    };
    if (!p || !rotation || !after.linear || !after.angular) return;
    node.moveTo({ p, q: quaternionOf(rotation) });
    if (node.movable && (after.linear !== linear || after.angular !== angular))
      node.setVelocityAtOrigin({ linear: after.linear, angular: after.angular });
    node.presence.unpark();
  }

  applyForce(force: Vec3, at: Vec3 | undefined): void {
    this.#apply('applyForce', force, at, (f, moment) => this.#push(f, moment));
  }

  applyTorque(torque: Vec3): void {
    this.#apply('applyTorque', torque, undefined, (t) => this.#push([0, 0, 0], t));
  }

  #push(force: Vec3, torque: Vec3): void {
    this.#node.world.registry.get(forces).push(this.#node, force, torque);
  }

  applyImpulse(impulse: Vec3, at: Vec3 | undefined): void {
    const node = this.#node;
    this.#apply('applyImpulse', impulse, at, (j, moment) => {
      const { scratch } = node.world.engine;
      node.motion.loadChanges();
      node.body.applyCentralImpulse(scratch.vector(...j));
      node.body.applyTorqueImpulse(scratch.vector(...moment));
      node.world.bodies.readVelocity(node);
    });
  }

  /** Hands `act` a force or impulse and its moment about the centre of mass, where it can act. */
  #apply(
    method: string,
    value: Vec3,
    at: Vec3 | undefined,
    act: (force: Vec3, moment: Vec3) => void,
  ): void {
    const force = this.argument<Vec3>(method, 'SFVec3f', value);
    const point = at === undefined ? undefined : this.argument<Vec3>(method, 'SFVec3f', at);
    if (!force || (at !== undefined && !point) || !this.#pushable()) return;
    act(force, point ? cross(subtract(point, this.#node.centerOfMassWorld()), force) : [0, 0, 0]);
  }

  #pushable(): boolean {
    const node = this.#node;
    node.world.flush();
    if (!node.active || !node.movable) return false;
    node.wake();
    return true;
  }

  /** What can't be read as finite numbers never reaches Bullet. */
  argument<T>(method: string, type: 'SFVec3f' | 'SFRotation', value: unknown): T | undefined {
    const accepted = codecs[type].accept(value);
    if (accepted !== undefined && guards.bounded(accepted as number[], BOUNDS.plain))
      return accepted as T;
    const { label } = this.#node;
    this.#node.report({
      code: 'bad-value',
      severity: 'warning',
      value,
      used: 'nothing',
      message: `${label}: ${method} takes ${type === 'SFVec3f' ? 'three' : 'four'} finite numbers up to ${shownBound(BOUNDS.plain)}, not ${show(value)}; nothing is done`,
    });
    return undefined;
  }
}
