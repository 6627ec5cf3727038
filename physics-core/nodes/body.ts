import type { BtBody } from '../engine/heap.js';
import { ACTIVATION, COLLISION_FLAG, RIGID_BODY_FLAG } from '../engine/offsets.js';
import { Owner } from '../engine/owner.js';
import type { Rotation, Value, Vec3 } from '../fields/types.js';
import { codecs } from '../fields/values.js';
import {
  add,
  compose,
  cross,
  identityPose,
  length,
  quaternionOf,
  rotate,
  rotationOf,
  subtract,
  type Pose,
} from '../math.js';
import { guards } from '../guards.js';
import type { BtShape } from '../shapes/build.js';
import { DEFAULT_FRICTION } from '../world/pairs.js';
import { POSE } from '../world/poses.js';
import { massOf, type MassProperties } from './body-mass.js';
import { shapeOf } from './body-shape.js';
import type { CollidableNode, CollidablePart } from './collidable.js';
import type { CollectionNode } from './rigid-body-collection.js';
import type { JointNode } from './joint.js';
import { PhysicsNode } from './node.js';

/** How a body comes to rest: never, unnoticed by the library, or by the X3D fields. */
export interface RestRule {
  mode: 'never' | 'library' | 'authored';
  time: number;
  linearSpeed: number;
  angularSpeed: number;
}

/** Metres that a fixed body is carried at once; at 60 frames per second that is 30 m/s. */
const LONGEST_CARRY = 0.5;

const samePose = (a: Pose, b: Pose): boolean =>
  a.p.every((value, i) => value === b.p[i]) && a.q.every((value, i) => value === b.q[i]);

/** A rigid body and its btRigidBody. Bullet's body frame is the centre of mass; X3D's is the body's origin. */
export class BodyNode extends PhysicsNode {
  /** Index into the world's poses; -1 while the body is not built. */
  slot = -1;
  pointer = 0;
  body!: BtBody;
  readonly joints = new Set<JointNode>();
  rest: RestRule = { mode: 'library', time: 0, linearSpeed: 0, angularSpeed: 0 };
  /** Pose at which it starts where the author gave none: of its Transform or collidable. */
  start: Pose | undefined;
  /** Made NaN by the last step and taken out of the world. */
  parked = false;

  #owner!: Owner;
  #shapeOwner!: Owner;
  /** Centre of mass and principal axes in the body's frame. */
  centerOfMass: Pose = identityPose();
  mass: MassProperties = { mass: 1, moments: [0.4, 0.4, 0.4], centerOfMass: identityPose() };
  #inWorld = false;
  #groups = [0, 0];
  #shapeMoving = false;
  #kinematic = false;
  /** Just created: the first round of patches finds everything in place already. */
  #fresh = false;

  // ---- creation -----------------------------------------------------------------------------------------------

  protected override create(): boolean {
    const { engine } = this.world;
    const { ammo, scratch } = engine;
    this.parked = false;
    this.#fresh = true;
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
    this.body = this.#owner.own(new ammo.btRigidBody(info));
    ammo.destroy(info);
    // Bullet multiplies the frictions of both bodies.
    this.body.setFriction(Math.sqrt(DEFAULT_FRICTION));
    this.pointer = ammo.getPointer(this.body);
    this.world.bodies.register(this);
    this.#place(this.startPose());
    return true;
  }

  protected override created(): void {
    this.#fresh = false;
    for (const joint of this.joints) joint.bodyReady();
  }

  protected override destroy(): void {
    for (const joint of this.joints) joint.bodyGone();
    this.world.registry.dropAll(this);
    this.#leaveWorld();
    this.#owner.dispose();
    this.#shapeOwner.dispose();
    this.world.bodies.release(this);
    this.slot = -1;
  }

  protected override released(): void {
    for (const collidable of this.collidables) collidable.release(this);
  }

  // ---- what it is made of -------------------------------------------------------------------------------------

  get collidables(): CollidableNode[] {
    return this.asked<CollidableNode[]>('geometry');
  }

  /** The parts that collide, in the body's frame. */
  get parts(): CollidablePart[] {
    return this.collidables.flatMap((collidable) =>
      collidable.owner === this ? collidable.parts() : [],
    );
  }

  /** Moves under forces. */
  get movable(): boolean {
    return !this.asked<boolean>('fixed') && this.asked<number>('mass') > 0;
  }

  #makeShape(): BtShape {
    this.#shapeMoving = this.movable;
    return shapeOf(this, this.#shapeOwner);
  }

  /** New geometry or a new centre of mass: another shape for the same btRigidBody; pose and velocity stay. */
  updateShape(): void {
    if (this.#fresh) return;
    const pose = this.pose();
    const velocity = this.velocityAtOrigin();
    const moved = !samePose(this.centerOfMass, massOf(this).centerOfMass);
    this.mass = massOf(this);
    this.centerOfMass = this.mass.centerOfMass;
    const old = this.#shapeOwner;
    this.#leaveWorld();
    this.#shapeOwner = new Owner(this.world.engine.ammo);
    this.body.setCollisionShape(this.#makeShape());
    old.dispose();
    this.#applyMass();
    this.#place(pose);
    if (this.movable) this.setVelocityAtOrigin(velocity);
    if (moved) for (const joint of this.joints) joint.reattach();
    this.updateMembership();
  }

  /** New mass, inertia or mobility. */
  updateMass(): void {
    this.#reportZeroMass();
    if (this.#fresh) return;
    const mass = massOf(this);
    if (!samePose(mass.centerOfMass, this.centerOfMass) || this.#shapeMoving !== this.movable) {
      this.updateShape();
      return;
    }
    this.mass = mass;
    this.#applyMass();
    this.wake();
  }

  #reportZeroMass(): void {
    if (this.asked<number>('mass') > 0) return;
    this.report({
      code: 'zero-mass',
      severity: 'info',
      attribute: 'mass',
      value: 0,
      used: 'fixed',
      message: `${this.label}: mass="0" makes it fixed`,
    });
  }

  #applyMass(): void {
    const { mass, moments } = this.mass;
    const { scratch } = this.world.engine;
    const movable = this.movable;
    const zero = scratch.vector(0, 0, 0);
    this.body.setMassProps(movable ? mass : 0, movable ? scratch.vector(...moments) : zero);
    this.#setFlags();
    if (!movable) this.setVelocityAtOrigin({ linear: [0, 0, 0], angular: [0, 0, 0] });
    this.body.updateInertiaTensor();
    this.updateGravity();
    for (const joint of this.joints) joint.massChanged();
  }

  #setFlags(): void {
    const flag = this.#kinematic ? COLLISION_FLAG.kinematic : COLLISION_FLAG.static;
    this.body.setCollisionFlags(this.movable ? 0 : flag);
    this.body.setFlags(RIGID_BODY_FLAG.ownGravity);
  }

  /** `fixed` switched: Bullet keeps movable and immovable bodies in different lists. */
  updateFixed(): void {
    if (this.#shapeMoving === this.movable) return;
    this.#leaveWorld();
    this.#kinematic = false;
    this.updateMass();
    this.#setFlags();
    this.updateMembership();
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
    this.#leaveWorld();
    if (!wanted) return;
    this.#groups = [group, mask];
    this.#setFlags();
    this.world.bullet.addBody(this.body, group, mask);
    this.#inWorld = true;
    this.updateGravity();
    this.world.contactParametersChanged(this);
    this.wake();
    for (const joint of this.joints) joint.bodyReady();
  }

  #leaveWorld(): void {
    if (!this.#inWorld) return;
    this.world.wakeTouching(this);
    for (const joint of this.joints) joint.bodyGone();
    this.world.bullet.removeBody(this.body);
    this.#inWorld = false;
  }

  updateGravity(): void {
    if (!this.built) return;
    const { scratch } = this.world.engine;
    const gravity: Vec3 = this.asked<boolean>('useGlobalGravity')
      ? this.settings.gravity
      : [0, 0, 0];
    this.body.setGravity(scratch.vector(...gravity));
    this.wake();
  }

  /** The collection whose gravity and defaults it has. */
  get settings(): Pick<CollectionNode, 'gravity' | 'asked' | 'authored'> {
    return this.collection ?? this.world.settings;
  }

  // ---- pose and velocity --------------------------------------------------------------------------------------

  /** Before it is built a body is where it will start. */
  override get(name: string): Value {
    const value = super.get(name);
    if (this.built || !this.start) return value;
    if (name === 'position') return this.startPose().p;
    return name === 'orientation' ? rotationOf(this.startPose().q) : value;
  }

  startPose(): Pose {
    const { p, q } = this.start ?? identityPose();
    return {
      p: this.authored('position') || !this.start ? [...this.asked<Vec3>('position')] : p,
      q:
        this.authored('orientation') || !this.start
          ? quaternionOf(this.asked<Rotation>('orientation'))
          : q,
    };
  }

  /** The pose of the body's origin at the last finished step. */
  pose(): Pose {
    const at = this.slot * POSE;
    const c = this.world.poses.current;
    return {
      p: [c[at]!, c[at + 1]!, c[at + 2]!],
      q: [c[at + 3]!, c[at + 4]!, c[at + 5]!, c[at + 6]!],
    };
  }

  /** Puts the body there at once. */
  #place(pose: Pose): void {
    const { scratch } = this.world.engine;
    const center = compose(pose, this.centerOfMass);
    // setWorldTransform would leave the world inertia tensor and the interpolation pose behind.
    this.body.setCenterOfMassTransform(scratch.transform(center.p, center.q));
    const { poses } = this.world;
    poses.current.set([...pose.p, ...pose.q], this.slot * POSE);
    poses.snap(this.slot);
  }

  /** Jumps to a pose; velocities stay. World frame, metres, axis and angle. */
  teleport(position: Vec3, orientation?: Rotation): void {
    this.world.flush();
    const p = this.#argument<Vec3>('teleport', 'SFVec3f', position);
    const turned = orientation === undefined ? rotationOf(this.pose().q) : orientation;
    const rotation = this.#argument<Rotation>('teleport', 'SFRotation', turned);
    if (p && rotation) this.moveTo({ p, q: quaternionOf(rotation) });
  }

  moveTo(pose: Pose): void {
    if (!this.built) {
      this.start = pose;
      return;
    }
    this.world.wakeTouching(this);
    const velocity = this.velocityAtOrigin();
    this.#place(pose);
    if (this.centerOfMass.p.some(Boolean)) this.setVelocityAtOrigin(velocity);
    this.wake();
  }

  /**
   * Where the author or an event puts it. A fixed body that is moved along is kinematic meanwhile, so that it pushes
   * others instead of jumping through them; a leap it makes as a jump.
   */
  carryTo(pose: Pose): void {
    const distance = length(subtract(pose.p, this.pose().p));
    if (this.#fresh || this.movable || !this.active || distance > LONGEST_CARRY) {
      this.moveTo(pose);
      return;
    }
    const from = compose(this.pose(), this.centerOfMass);
    this.#kinematic = true;
    this.#setFlags();
    this.world.wakeTouching(this);
    this.#place(pose);
    this.body.forceActivationState(ACTIVATION.alwaysActive);
    this.world.registry.carrying.carried(this, from, compose(pose, this.centerOfMass));
  }

  /** Carried no longer: static again. */
  standStill(): void {
    if (!this.built || this.movable) return;
    this.#kinematic = false;
    this.#setFlags();
    // As Bullet itself has immovable bodies: two of them are then not tested against each other.
    this.body.forceActivationState(ACTIVATION.sleeping);
    this.#place(this.pose());
  }

  /** Velocities of the body's origin, world frame. */
  velocityAtOrigin(): { linear: Vec3; angular: Vec3 } {
    const [vx, vy, vz, wx, wy, wz] = this.world.bodies.velocityOf(this);
    const angular: Vec3 = [wx!, wy!, wz!];
    const arm = rotate(this.pose().q, this.centerOfMass.p);
    return { linear: subtract([vx!, vy!, vz!], cross(angular, arm)), angular };
  }

  setVelocityAtOrigin({ linear, angular }: { linear: Vec3; angular: Vec3 }): void {
    const { scratch } = this.world.engine;
    const arm = rotate(this.pose().q, this.centerOfMass.p);
    this.body.setLinearVelocity(scratch.vector(...add(linear, cross(angular, arm))));
    this.body.setAngularVelocity(scratch.vector(...angular));
    this.world.bodies.readVelocity(this);
  }

  updateVelocity(part: 'linearVelocity' | 'angularVelocity'): void {
    if (!this.movable) return;
    const velocity = this.velocityAtOrigin();
    const value = [...this.asked<Vec3>(part)] as Vec3;
    this.setVelocityAtOrigin(
      part === 'linearVelocity' ? { ...velocity, linear: value } : { ...velocity, angular: value },
    );
    this.wake();
  }

  /** Position (3) and quaternion (4) of the last finished step, without allocation. */
  readPose(out: Float32Array | Float64Array | number[]): typeof out {
    const { current } = this.world.poses;
    for (let i = 0; i < POSE; i++) out[i] = this.slot < 0 ? 0 : current[this.slot * POSE + i]!;
    return out;
  }

  // ---- forces -------------------------------------------------------------------------------------------------

  /** Newtons in the world frame for the next timeStep, at a world point or the centre of mass. */
  applyForce(force: Vec3, at?: Vec3): void {
    const load = this.#load('applyForce', force, at);
    if (load) this.world.push(this, ...load);
  }

  /** Newton metres in the world frame for the next timeStep. */
  applyTorque(torque: Vec3): void {
    const load = this.#load('applyTorque', torque);
    if (load) this.world.push(this, [0, 0, 0], load[0]);
  }

  /** Newton seconds at once, at a world point or the centre of mass. */
  applyImpulse(impulse: Vec3, at?: Vec3): void {
    const load = this.#load('applyImpulse', impulse, at);
    if (!load) return;
    const { scratch } = this.world.engine;
    this.body.applyCentralImpulse(scratch.vector(...load[0]));
    this.body.applyTorqueImpulse(scratch.vector(...load[1]));
    this.world.bodies.readVelocity(this);
  }

  /** A force or impulse and its moment about the centre of mass; undefined where it can't act. */
  #load(method: string, value: Vec3, at?: Vec3): [Vec3, Vec3] | undefined {
    const force = this.#argument<Vec3>(method, 'SFVec3f', value);
    const point = at === undefined ? undefined : this.#argument<Vec3>(method, 'SFVec3f', at);
    if (!force || (at !== undefined && !point) || !this.#pushable()) return undefined;
    return [force, point ? cross(subtract(point, this.centerOfMassWorld()), force) : [0, 0, 0]];
  }

  /** What can't be read as finite numbers never reaches Bullet. */
  #argument<T>(method: string, type: 'SFVec3f' | 'SFRotation', value: unknown): T | undefined {
    const accepted = codecs[type].accept(value);
    if (accepted !== undefined && guards.finiteVector(accepted as number[])) return accepted as T;
    this.report({
      code: 'bad-value',
      severity: 'warning',
      value,
      used: 'nothing',
      message: `${this.label}: ${method} takes ${type === 'SFVec3f' ? 'three' : 'four'} finite numbers, not ${String(value)}; nothing is done`,
    });
    return undefined;
  }

  #pushable(): boolean {
    this.world.flush();
    if (!this.active || !this.movable) return false;
    this.wake();
    return true;
  }

  centerOfMassWorld(): Vec3 {
    return compose(this.pose(), this.centerOfMass).p;
  }

  updateForces(): void {
    const sum = (name: string): Vec3 =>
      this.asked<Vec3[]>(name).reduce<Vec3>((total, value) => add(total, value), [0, 0, 0]);
    this.world.registry.forces.set(this, sum('forces'), sum('torques'));
    this.wake();
  }

  updateDamping(): void {
    this.world.registry.damping.update(this);
  }

  // ---- rest ---------------------------------------------------------------------------------------------------

  updateRest(): void {
    const from = (name: string): Value =>
      this.authored(name) ? this.asked(name) : this.settings.asked(name);
    const authored = this.authored('autoDisable') || this.settings.authored('autoDisable');
    const never = authored ? !from('autoDisable') : this.settings.asked('rest') === 'never';
    this.rest = {
      mode: never ? 'never' : authored ? 'authored' : 'library',
      time: from('disableTime') as number,
      linearSpeed: from('disableLinearSpeed') as number,
      angularSpeed: from('disableAngularSpeed') as number,
    };
    this.world.registry.resting.update(this);
    this.wake();
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
    this.#leaveWorld();
    const { scratch } = this.world.engine;
    this.body.setLinearVelocity(scratch.vector(0, 0, 0));
    this.body.setAngularVelocity(scratch.vector(0, 0, 0));
    this.body.clearForces();
    this.#place(this.pose());
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
    this.#leaveWorld();
    this.body.clearForces();
    this.#place(this.pose());
    this.setVelocityAtOrigin(velocity);
    this.updateMembership();
  }

  /** An edit of pose or velocity gives a parked body another try. */
  unpark(): void {
    if (!this.parked) return;
    this.parked = false;
    this.world.settle(this, undefined, 'nan-state');
    this.updateMembership();
  }
}
