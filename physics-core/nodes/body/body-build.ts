import type { Pose } from '../../base/math.js';
import { pairFilter } from '../../effects/contacts/effects.js';
import { carrying } from '../../effects/drag/effects.js';
import type { BodyNode } from './body.js';
import { massOf, reportZeroMass } from './body-mass.js';

const samePose = (a: Pose, b: Pose): boolean =>
  a.p.every((value, i) => value === b.p[i]) && a.q.every((value, i) => value === b.q[i]);

/** What a body is made of: shape, mass, and whether it moves. An edit changes these in the same btRigidBody. */
export class BodyBuild {
  readonly #node: BodyNode;

  constructor(node: BodyNode) {
    this.#node = node;
  }

  shapeChanges(): void {
    const node = this.#node;
    node.isDynamic = node.movable;
    node.world.bodies.review(node);
    node.world.registry.find(pairFilter)?.forget();
  }

  /**
   * New geometry or a new centre of mass: another shape for the same btRigidBody; pose and velocity stay. Joints hold on
   * to it, unless the frame in which they do is another now.
   */
  updateShape(): void {
    const node = this.#node;
    if (node.fresh) return;
    const pose = node.pose();
    node.motion.loadChanges();
    const velocity = node.velocityAtOrigin();
    node.mass = massOf(node);
    if (!samePose(node.mass.centerOfMass, node.centerOfMass))
      for (const joint of node.joints) joint.bodyGone();
    node.centerOfMass = node.mass.centerOfMass;
    node.object.leave();
    this.shapeChanges();
    node.object.replaceShape();
    this.#applyMass();
    node.motion.place(pose);
    if (node.movable) node.setVelocityAtOrigin(velocity);
    node.presence.update();
  }

  /** New mass, inertia or mobility. */
  updateMass(): void {
    const node = this.#node;
    reportZeroMass(node);
    if (node.fresh) return;
    node.grip.massChanged();
    const mass = massOf(node);
    if (!samePose(mass.centerOfMass, node.centerOfMass) || node.isDynamic !== node.movable) {
      this.updateShape();
      return;
    }
    node.motion.loadChanges();
    node.mass = mass;
    this.#applyMass();
    node.wake();
  }

  #applyMass(): void {
    const node = this.#node;
    node.object.setMass();
    node.world.bodies.review(node);
    node.world.bullet.forgetImpulsesOf(node.pointer);
    node.loads.applyDamping();
    node.loads.applyGravity();
    node.changed('mass');
    for (const joint of node.joints) joint.massChanged();
  }

  /** It stays in the world, and so do its joints: only the solvers see another mass. */
  mobilityChanged(): void {
    const node = this.#node;
    node.motion.kinematic = false;
    node.world.registry.find(carrying)?.release(node);
    for (const joint of node.joints) node.world.registry.jointChanged(joint);
    // Its shape was made anew while it was held.
    if (node.movable && !node.isDynamic) return this.updateFixed();
    node.object.setMass();
    node.loads.updateGravity();
    // Put into the world again meanwhile, Bullet would have it among what never moves.
    if (node.movable && node.object.inWorld) {
      node.presence.partContacts();
      node.wake();
    }
  }

  /** `fixed` switched: Bullet keeps movable and immovable bodies in different lists. */
  updateFixed(): void {
    const node = this.#node;
    if (node.isDynamic === node.movable) return;
    node.object.leave();
    node.motion.kinematic = false;
    this.updateMass();
    node.object.setFlags();
    node.presence.update();
  }
}
