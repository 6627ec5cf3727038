import { contactReader } from '../../effects/contacts/effects.js';
import { dragging } from '../../effects/drag/dragging.js';
import { continuousCollision, sweptEnds } from '../../effects/hits/effects.js';
import type { BodyNode } from './body.js';

/** Whether a body stands in the world: as its fields say, and as long as its numbers are finite. */
export class BodyPresence {
  readonly #node: BodyNode;
  /** Made NaN by the last step and taken out of the world. */
  parked = false;

  constructor(node: BodyNode) {
    this.#node = node;
  }

  /** Adds it, takes it out, or moves it to other collision groups. */
  update(): void {
    const node = this.#node;
    const { registry: effects, pairs } = node.world;
    const groups = pairs.groupsOf(node);
    const enabled = node.asked<boolean>('enabled');
    const wanted = enabled && !this.parked;
    if (wanted && node.object.isIn(groups)) return;
    if (!enabled) effects.find(contactReader)?.part(node, 'disabled');
    if (!wanted) {
      this.goOut();
      effects.find(dragging)?.letGo(node, 'disabled');
      return;
    }
    node.object.enter(groups);
    node.loads.updateGravity();
    node.world.pairs.contactsChanged(node);
    node.wake();
    for (const joint of node.joints) joint.bodyReady();
  }

  /** Lets go of what it touches. */
  partContacts(): void {
    const node = this.#node;
    node.object.partContacts();
    node.loads.updateGravity();
  }

  /** Its joints let go of it, too. */
  goOut(): void {
    const node = this.#node;
    for (const joint of node.joints) joint.bodyGone();
    node.object.leave();
    node.world.registry.find(continuousCollision)?.release(node);
    node.world.registry.find(sweptEnds)?.release(node);
  }

  /** A step left it without finite numbers: back to the last good pose, and out of the world until it is edited. */
  park(): void {
    const node = this.#node;
    this.parked = true;
    this.goOut();
    const { scratch } = node.world.engine;
    node.body.setLinearVelocity(scratch.vector(0, 0, 0));
    node.body.setAngularVelocity(scratch.vector(0, 0, 0));
    node.body.clearForces();
    node.motion.place(node.pose());
    node.world.bodies.readVelocity(node);
    node.report({
      code: 'nan-state',
      severity: 'error',
      used: 'its last good pose',
      message: `${node.label}: the simulation lost its numbers (NaN); it is taken out of the step at its last good pose`,
    });
  }

  /** Another body lost its numbers and broke this one: back to before the step, without contacts and joint impulses. */
  recover(): void {
    const node = this.#node;
    const velocity = node.velocityAtOrigin();
    this.goOut();
    node.body.clearForces();
    node.motion.place(node.pose());
    node.setVelocityAtOrigin(velocity);
    this.update();
  }

  /** An edit of its pose gives a parked body another try. */
  unpark(): void {
    const node = this.#node;
    if (!this.parked) return;
    this.parked = false;
    node.settle(undefined, 'nan-state');
    this.update();
  }
}
