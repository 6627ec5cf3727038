import type { BtBody } from '../engine/heap.js';
import { ACTIVATION, COLLISION_FLAG, RIGID_BODY_FLAG } from '../engine/offsets.js';
import type { Rotation, Value, Vec3 } from '../fields/types.js';
import { codecs } from '../fields/values.js';
import { guards, LARGEST } from '../base/guards.js';
import { show } from '../base/show.js';
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
} from '../base/math.js';
import { POSE } from '../dynamics/poses.js';
import { wakeTouching } from '../effects/rest/touching.js';
import type { JointNode } from './joint.js';
import { PhysicsNode } from './node.js';

/** Metres that a fixed body is carried at once; at 60 frames per second that is 30 m/s. */
const LONGEST_CARRY = 0.5;

/** World frame, m/s and rad/s. */
export interface Velocities {
  linearVelocity: Vec3;
  angularVelocity: Vec3;
}

/** Where a body is, how it moves, and what pushes it. Bullet's body frame is the centre of mass; X3D's is the body's origin. */
export abstract class MovingNode extends PhysicsNode {
  /** Index into the world's poses; -1 while the body is not built. */
  slot = -1;
  pointer = 0;
  body!: BtBody;
  /** Pose at which it starts where the author gave none: of its Transform or collidable. */
  start: Pose | undefined;
  /** Centre of mass and principal axes in the body's frame. */
  centerOfMass: Pose = identityPose();
  /** Just created: the first round of patches finds everything in place already. */
  protected fresh = false;
  /** Carried along by its author: it pushes others. */
  kinematic = false;

  abstract readonly joints: ReadonlySet<JointNode>;

  /** Whether it is simulated at all. */
  abstract get active(): boolean;

  abstract get sleeping(): boolean;

  abstract wake(): void;

  abstract unpark(): void;

  /** Moves under forces. */
  get movable(): boolean {
    return !this.asked<boolean>('fixed') && this.asked<number>('mass') > 0;
  }

  protected setFlags(): void {
    const flag = this.kinematic ? COLLISION_FLAG.kinematic : COLLISION_FLAG.static;
    this.body.setCollisionFlags(this.movable ? 0 : flag);
    this.body.setFlags(RIGID_BODY_FLAG.ownGravity);
  }

  // ---- pose ---------------------------------------------------------------------------------------------------

  /** Before it is built a body is where it will start. */
  override get(name: string): Value {
    const value = super.get(name);
    if (this.built || !this.start) return value;
    if (name === 'position') return this.startPose().p;
    return name === 'orientation' ? rotationOf(this.startPose().q) : value;
  }

  startPose(): Pose {
    const { p, q } = this.#soundStart();
    return {
      p: this.authored('position') || !this.start ? [...this.asked<Vec3>('position')] : p,
      q:
        this.authored('orientation') || !this.start
          ? quaternionOf(this.asked<Rotation>('orientation'))
          : q,
    };
  }

  /** What it stands for may be anywhere, also where no number of single precision reaches. */
  #soundStart(): Pose {
    const { p, q } = this.start ?? identityPose();
    if (guards.finiteVector([...p, ...q])) return { p, q };
    this.report({
      code: 'out-of-range',
      severity: 'warning',
      value: p,
      used: [0, 0, 0],
      message: `${this.label} would start at ${show(p)}, beyond ±${LARGEST}, the most that single precision holds; 0 0 0 is used`,
    });
    return identityPose();
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
  place(pose: Pose): void {
    const { scratch } = this.world.engine;
    const center = compose(pose, this.centerOfMass);
    // setWorldTransform would leave the world inertia tensor and the interpolation pose behind.
    this.body.setCenterOfMassTransform(scratch.transform(center.p, center.q));
    const { poses } = this.world;
    this.world.rays.moved();
    poses.current.set([...pose.p, ...pose.q], this.slot * POSE);
    poses.snap(this.slot);
  }

  /**
   * Jumps to a pose: world frame, metres, axis and angle. What is left out stays: its orientation, and each of its
   * velocities, m/s and rad/s, in the world frame. It is no edit of the fields: `position` set to what it was last set to
   * before is still no edit, and to anything else moves the body there.
   */
  teleport(position: Vec3, orientation?: Rotation, velocities: Partial<Velocities> = {}): void {
    this.world.events.during(() => this.#teleport(position, orientation, velocities));
  }

  #teleport(
    position: Vec3,
    orientation: Rotation | undefined,
    velocities: Partial<Velocities>,
  ): void {
    this.world.flush();
    const given = <T>(type: 'SFVec3f' | 'SFRotation', value: unknown, now: T): T | undefined =>
      value === undefined ? now : this.argument<T>('teleport', type, value);
    if (!this.built) return;
    const { linear, angular } = this.velocityAtOrigin();
    const p = this.argument<Vec3>('teleport', 'SFVec3f', position);
    const rotation = given('SFRotation', orientation, rotationOf(this.pose().q));
    const after = {
      linear: given('SFVec3f', velocities?.linearVelocity, linear),
      angular: given('SFVec3f', velocities?.angularVelocity, angular),
    };
    if (!p || !rotation || !after.linear || !after.angular) return;
    this.moveTo({ p, q: quaternionOf(rotation) });
    if (this.movable && (after.linear !== linear || after.angular !== angular))
      this.setVelocityAtOrigin({ linear: after.linear, angular: after.angular });
    this.unpark();
  }

  moveTo(pose: Pose): void {
    if (!this.built) {
      this.start = pose;
      return;
    }
    wakeTouching(this);
    const velocity = this.velocityAtOrigin();
    this.place(pose);
    this.world.registry.gyroscopic.forget(this);
    if (this.centerOfMass.p.some(Boolean)) this.setVelocityAtOrigin(velocity);
    this.wake();
  }

  /**
   * Where the author or an event puts it. A fixed body that is moved along is kinematic meanwhile, so that it pushes
   * others instead of jumping through them; a leap it makes as a jump.
   */
  carryTo(pose: Pose): void {
    const distance = length(subtract(pose.p, this.pose().p));
    if (this.fresh || this.movable || !this.active || distance > LONGEST_CARRY) {
      this.moveTo(pose);
      return;
    }
    const from = compose(this.pose(), this.centerOfMass);
    this.kinematic = true;
    this.setFlags();
    wakeTouching(this);
    this.place(pose);
    this.body.forceActivationState(ACTIVATION.alwaysActive);
    this.world.registry.carrying.carried(this, from, compose(pose, this.centerOfMass));
  }

  /** Carried no longer: static again. */
  standStill(): void {
    if (!this.built || this.movable) return;
    this.kinematic = false;
    this.setFlags();
    // As Bullet itself has immovable bodies: two of them are then not tested against each other.
    this.body.forceActivationState(ACTIVATION.sleeping);
    this.place(this.pose());
  }

  // ---- velocity -----------------------------------------------------------------------------------------------

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
    this.world.registry.joints.relaunch(this);
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
    this.#apply('applyForce', force, at, (f, moment) => this.world.push(this, f, moment));
  }

  /** Newton metres in the world frame for the next timeStep. */
  applyTorque(torque: Vec3): void {
    this.#apply('applyTorque', torque, undefined, (t) => this.world.push(this, [0, 0, 0], t));
  }

  /** Newton seconds at once, at a world point or the centre of mass. */
  applyImpulse(impulse: Vec3, at?: Vec3): void {
    this.#apply('applyImpulse', impulse, at, (j, moment) => {
      const { scratch } = this.world.engine;
      this.body.applyCentralImpulse(scratch.vector(...j));
      this.body.applyTorqueImpulse(scratch.vector(...moment));
      this.world.bodies.readVelocity(this);
    });
  }

  /** Hands `act` a force or impulse and its moment about the centre of mass, where it can act. */
  #apply(
    method: string,
    value: Vec3,
    at: Vec3 | undefined,
    act: (force: Vec3, moment: Vec3) => void,
  ): void {
    this.world.events.during(() => {
      const force = this.argument<Vec3>(method, 'SFVec3f', value);
      const point = at === undefined ? undefined : this.argument<Vec3>(method, 'SFVec3f', at);
      if (!force || (at !== undefined && !point) || !this.#pushable()) return;
      act(force, point ? cross(subtract(point, this.centerOfMassWorld()), force) : [0, 0, 0]);
    });
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

  /** What can't be read as finite numbers never reaches Bullet. */
  argument<T>(method: string, type: 'SFVec3f' | 'SFRotation', value: unknown): T | undefined {
    const accepted = codecs[type].accept(value);
    if (accepted !== undefined && guards.finiteVector(accepted as number[])) return accepted as T;
    this.report({
      code: 'bad-value',
      severity: 'warning',
      value,
      used: 'nothing',
      message: `${this.label}: ${method} takes ${type === 'SFVec3f' ? 'three' : 'four'} finite numbers below ${LARGEST}, not ${show(value)}; nothing is done`,
    });
    return undefined;
  }
}
