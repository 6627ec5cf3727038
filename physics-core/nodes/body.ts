import { Owner } from '../engine/owner.js';
import type { Vec3 } from '../fields/types.js';
import { add, identityPose, type Pose } from '../base/math.js';
import type { BtShape } from '../shapes/build.js';
import { DEFAULT_FRICTION } from '../world/pairs.js';
import { wakeTouching } from '../effects/rest/touching.js';
import type { PhysicsNode } from './node.js';
import { massOf, reportZeroMass, type MassProperties } from './body-mass.js';
import { HeldNode } from './body-held.js';
import { restRuleOf, sameRule, type RestRule } from './body-rest.js';
import { shapeOf } from './body-shape.js';
import type { CollidableNode, CollidablePart } from './collidable.js';
import type { CollectionNode } from './rigid-body-collection.js';
import type { JointNode } from './joint.js';

const WEIGHTLESS: Vec3 = [0, 0, 0];

const samePose = (a: Pose, b: Pose): boolean =>
  a.p.every((value, i) => value === b.p[i]) && a.q.every((value, i) => value === b.q[i]);

/** A rigid body and its btRigidBody. Bullet's body frame is the centre of mass; X3D's is the body's origin. */
export class BodyNode extends HeldNode {
  /** The acceleration that Bullet gives it, m/s². */
  pulled: Vec3 = WEIGHTLESS;
  /** Shares of its velocities that Bullet's damping takes per second. */
  dampedShare = { linear: 0, angular: 0 };
  readonly joints = new Set<JointNode>();
  rest: RestRule = { mode: 'library', time: 0, linearSpeed: 0, angularSpeed: 0 };
  /** Whether it is movable in Bullet: `movable`, which asks two fields, as of the last edit. */
  moves = false;
  /** Made NaN by the last step and taken out of the world. */
  parked = false;

  #owner: Owner | undefined;
  #shapeOwner: Owner | undefined;
  mass: MassProperties = { mass: 1, moments: [0.4, 0.4, 0.4], centerOfMass: identityPose() };
  #inWorld = false;
  #groups = [0, 0];

  // ---- creation -----------------------------------------------------------------------------------------------

  protected override create(): boolean {
    const { engine } = this.world;
    const { ammo, scratch } = engine;
    this.parked = false;
    this.fresh = true;
    this.slot = this.world.bodies.take(this);
    this.#owner = new Owner(ammo);
    this.#shapeOwner = new Owner(ammo);
    this.mass = massOf(this);
    this.centerOfMass = this.mass.centerOfMass;
    const shape = this.#makeShape();
    // Bullet takes an inertia at mass 0 too, and would let joints and contacts turn the immovable body.
    const moments: Vec3 = this.movable ? this.mass.moments : [0, 0, 0];
    const inertia = scratch.vector(...moments);
    const info = new ammo.btRigidBodyConstructionInfo(
      this.movable ? this.mass.mass : 0,
      null as never,
      shape,
      inertia,
    );
    try {
      this.body = this.#owner.own(new ammo.btRigidBody(info));
    } finally {
      ammo.destroy(info);
    }
    // Bullet multiplies the frictions of both bodies.
    this.body.setFriction(Math.sqrt(DEFAULT_FRICTION));
    this.pointer = ammo.getPointer(this.body);
    this.world.bodies.register(this);
    this.place(this.startPose());
    return true;
  }

  protected override created(): void {
    this.fresh = false;
    this.world.registry.gyroscopic.update(this);
    for (const joint of this.joints) joint.bodyReady();
  }

  protected override destroy(): void {
    // A world made anew has told already.
    this.world.registry.contacts.part(this, 'removed');
    this.#goOut();
    this.world.pairs.kinds.leave(this);
    this.world.registry.dropAll(this);
    this.withdraw();
    this.#owner?.dispose();
    this.#shapeOwner?.dispose();
    this.world.bodies.release(this);
    this.slot = -1;
  }

  protected override released(): void {
    for (const collidable of this.collidables) collidable.release(this);
  }

  /** Whether the world made it for a collidable without a body. */
  get isObstacle(): boolean {
    return false;
  }

  /** The node that authors know it by. */
  get standsFor(): PhysicsNode {
    return this;
  }

  // ---- what it is made of -------------------------------------------------------------------------------------

  get collidables(): CollidableNode[] {
    return this.asked<CollidableNode[]>('geometry');
  }

  /** The parts that collide, in the body's frame. */
  get parts(): CollidablePart[] {
    return this.collidables.flatMap((collidable) =>
      collidable.owner === this && !collidable.removed ? collidable.parts() : [],
    );
  }

  /** Those of its parts that have a shape in Bullet, in Bullet's order. */
  solidParts: CollidablePart[] = [];

  #makeShape(): BtShape {
    this.moves = this.movable;
    this.world.registry.filter.forget();
    const { shape, parts } = shapeOf(this, this.#shapeOwner!);
    this.solidParts = parts;
    return shape;
  }

  /**
   * New geometry or a new centre of mass: another shape for the same btRigidBody; pose and velocity stay. Joints hold on
   * to it, unless the frame in which they do is another now.
   */
  updateShape(): void {
    if (this.fresh) return;
    const pose = this.pose();
    const velocity = this.velocityAtOrigin();
    this.mass = massOf(this);
    if (!samePose(this.mass.centerOfMass, this.centerOfMass))
      for (const joint of this.joints) joint.bodyGone();
    this.centerOfMass = this.mass.centerOfMass;
    const old = this.#shapeOwner;
    this.#leaveWorld();
    this.#shapeOwner = new Owner(this.world.engine.ammo);
    try {
      this.body.setCollisionShape(this.#makeShape());
    } finally {
      old?.dispose();
    }
    this.#applyMass();
    this.place(pose);
    if (this.movable) this.setVelocityAtOrigin(velocity);
    this.updateMembership();
  }

  /** New mass, inertia or mobility. */
  updateMass(): void {
    reportZeroMass(this);
    if (this.fresh) return;
    this.updateDraggable();
    const mass = massOf(this);
    if (!samePose(mass.centerOfMass, this.centerOfMass) || this.moves !== this.movable) {
      this.updateShape();
      return;
    }
    this.mass = mass;
    this.#applyMass();
    this.wake();
  }

  #applyMass(): void {
    this.#setMass();
    this.updateGravity();
    this.#momentsChanged();
    for (const joint of this.joints) joint.massChanged();
  }

  #setMass(): void {
    const { mass, moments } = this.mass;
    const { scratch } = this.world.engine;
    const movable = this.movable;
    const zero = scratch.vector(0, 0, 0);
    this.body.setMassProps(movable ? mass : 0, movable ? scratch.vector(...moments) : zero);
    this.setFlags();
    if (!movable) this.setVelocityAtOrigin({ linear: [0, 0, 0], angular: [0, 0, 0] });
    this.body.updateInertiaTensor();
  }

  /** It stays in the world, and so do its joints: only the solvers see another mass. */
  protected override mobilityChanged(): void {
    this.kinematic = false;
    this.world.registry.carrying.drop(this);
    for (const joint of this.joints) this.world.registry.joints.update(joint);
    // Its shape was made anew while it was held.
    if (this.movable && !this.moves) return this.updateFixed();
    this.#setMass();
    this.updateGravity();
    // Put into the world again meanwhile, Bullet would have it among what never moves.
    if (this.movable && this.#inWorld) {
      this.partContacts();
      this.wake();
    }
  }

  #momentsChanged(): void {
    this.updateDamping();
    this.world.registry.gyroscopic.update(this);
  }

  /** `fixed` switched: Bullet keeps movable and immovable bodies in different lists. */
  updateFixed(): void {
    if (this.moves === this.movable) return;
    this.#leaveWorld();
    this.kinematic = false;
    this.updateMass();
    this.setFlags();
    this.updateMembership();
  }

  /** Joints hang on to where an immovable body is put. */
  override place(pose: Pose): void {
    super.place(pose);
    if (!this.movable && this.joints.size > 0) this.world.registry.joints.carried(this);
  }

  // ---- in the world -------------------------------------------------------------------------------------------

  /** Whether it is simulated at all. */
  get active(): boolean {
    return this.built && this.#inWorld;
  }

  /** Adds it, takes it out, or moves it to other collision groups. */
  updateMembership(): void {
    const [group, mask] = this.world.pairs.groupsOf(this);
    const wanted = this.asked<boolean>('enabled') && !this.parked;
    if (this.#inWorld && wanted && group === this.#groups[0] && mask === this.#groups[1]) return;
    if (!this.asked<boolean>('enabled')) this.world.registry.contacts.part(this, 'disabled');
    if (!wanted) {
      this.#goOut();
      this.world.registry.dragging.letGo(this, 'disabled');
      return;
    }
    this.#leaveWorld();
    this.#groups = [group, mask];
    this.setFlags();
    this.world.bullet.addBody(this.body, group, mask);
    this.#inWorld = true;
    this.updateGravity();
    this.world.contactParametersChanged(this);
    this.wake();
    for (const joint of this.joints) joint.bodyReady();
  }

  /** Lets go of what it touches: Bullet keeps the contacts of a pair that is no longer to be tested. */
  partContacts(): void {
    const { bullet } = this.world;
    bullet.removeBody(this.body);
    bullet.addBody(this.body, this.#groups[0]!, this.#groups[1]!);
    this.updateGravity();
  }

  /** Its joints let go of it, too. */
  #goOut(): void {
    for (const joint of this.joints) joint.bodyGone();
    this.#leaveWorld();
    this.world.registry.continuous.drop(this);
  }

  /** Only to come back at once, with other groups or another shape. */
  #leaveWorld(): void {
    if (!this.#inWorld) return;
    wakeTouching(this);
    this.world.bullet.removeBody(this.body);
    this.#inWorld = false;
  }

  updateGravity(): void {
    if (!this.built) return;
    const { gravity } = this;
    if (!gravity.every((value, i) => value === this.pulled[i])) this.wake();
    this.pulled = gravity;
    this.body.setGravity(this.world.engine.scratch.vector(...gravity));
    this.world.registry.flight.update(this);
  }

  /** Its own acceleration, m/s². */
  get gravity(): Vec3 {
    return this.asked<boolean>('useGlobalGravity') ? this.settings.gravity : WEIGHTLESS;
  }

  /** The collection whose gravity and defaults it has. */
  get settings(): Pick<CollectionNode, 'gravity' | 'asked' | 'authored'> {
    return this.collection ?? this.world.settings;
  }

  /** Gravity, rest and who it collides with are those of its collection. */
  override belongTo(collection: CollectionNode | undefined): void {
    super.belongTo(collection);
    for (const field of ['useGlobalGravity', 'autoDisable', 'dragMode']) this.touch(field);
    this.world.pairs.refreshBody(this);
  }

  // ---- forces, rest -------------------------------------------------------------------------------------------

  updateForces(): void {
    const sum = (name: string): Vec3 =>
      this.asked<Vec3[]>(name).reduce<Vec3>((total, value) => add(total, value), [0, 0, 0]);
    this.world.registry.forces.set(this, sum('forces'), sum('torques'));
    this.world.registry.flight.update(this);
    this.wake();
  }

  updateDamping(): void {
    this.world.registry.damping.update(this);
    this.world.registry.flight.update(this);
  }

  updateRest(): void {
    const rest = restRuleOf(this);
    if (!sameRule(rest, this.rest)) this.wake();
    this.rest = rest;
    this.world.registry.resting.update(this);
  }

  get sleeping(): boolean {
    return this.active && this.movable && this.world.bodies.asleep(this);
  }

  wake(): void {
    if (this.active && this.movable) this.world.bodies.wake(this);
  }

  sleep(): void {
    if (this.active && this.movable) this.world.bodies.sleep(this);
  }

  // ---- when its numbers break -----------------------------------------------------------------------------------

  /** A step left it without finite numbers: back to the last good pose, and out of the world until it is edited. */
  park(): void {
    this.parked = true;
    this.#goOut();
    const { scratch } = this.world.engine;
    this.body.setLinearVelocity(scratch.vector(0, 0, 0));
    this.body.setAngularVelocity(scratch.vector(0, 0, 0));
    this.body.clearForces();
    this.place(this.pose());
    this.world.bodies.readVelocity(this);
    this.report({
      code: 'nan-state',
      severity: 'error',
      used: 'its last good pose',
      message: `${this.label}: the simulation lost its numbers (NaN); it is taken out of the step at its last good pose`,
    });
  }

  /** Another body lost its numbers and broke this one: back to before the step, without contacts and joint impulses. */
  recover(): void {
    const velocity = this.velocityAtOrigin();
    this.#goOut();
    this.body.clearForces();
    this.place(this.pose());
    this.setVelocityAtOrigin(velocity);
    this.updateMembership();
  }

  /** An edit of its pose gives a parked body another try. */
  override unpark(): void {
    if (!this.parked) return;
    this.parked = false;
    this.world.settle(this, undefined, 'nan-state');
    this.updateMembership();
  }
}
