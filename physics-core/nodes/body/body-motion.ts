import { BOUNDS, shownBound } from '../../fields/bounds.js';
import { guards } from '../../base/guards.js';
import {
  add,
  compose,
  cross,
  identityPose,
  length,
  quaternionOf,
  rotate,
  subtract,
  type Pose,
} from '../../base/math.js';
import { show } from '../../base/show.js';
import type { Velocity } from '../../dynamics/body.js';
import { POSE } from '../../dynamics/poses.js';
import { carrying } from '../../effects/drag/effects.js';
import { contacts } from '../../effects/effect/chunks.js';
import { gyroscopic } from '../../effects/flight/gyroscopic.js';
import { jointSolve } from '../../effects/joints/effects.js';
import { wakeTouching } from '../../effects/rest/touching.js';
import { keepAwake, putToSleep } from '../../engine/body-state.js';
import type { Rotation, Vec3 } from '../../fields/types.js';
import type { BodyNode } from './body.js';

/** Metres that a fixed body is carried at once; at 60 frames per second that is 30 m/s. */
const LONGEST_CARRY = 0.5;

/** Where a body is and how it moves. Bullet's body frame is the centre of mass; X3D's is the body's origin. */
export class BodyMotion {
  readonly #node: BodyNode;
  /** Pose at which it starts where the author gave none: of its Transform or collidable. */
  start: Pose | undefined;
  /** Carried along by its author: it pushes others. */
  kinematic = false;

  constructor(node: BodyNode) {
    this.#node = node;
  }

  // ---- pose -------------------------------------------------------------------------------------------------------

  startPose(): Pose {
    const node = this.#node;
    const { p, q } = this.#soundStart();
    const own = (field: string): boolean => node.authored(field) || !this.start;
    return {
      p: own('position') ? [...node.asked<Vec3>('position')] : p,
      q: own('orientation') ? quaternionOf(node.asked<Rotation>('orientation')) : q,
    };
  }

  /** What it stands for may be anywhere, also where no number of single precision reaches. */
  #soundStart(): Pose {
    const { p, q } = this.start ?? identityPose();
    if (guards.bounded([...p, ...q], BOUNDS.plain)) return { p, q };
    this.#node.report({
      code: 'out-of-range',
      severity: 'warning',
      value: p,
      used: [0, 0, 0],
      message: `${this.#node.label} would start at ${show(p)}, beyond ±${shownBound(BOUNDS.plain)}, the most that it may be; 0 0 0 is used`,
    });
    return identityPose();
  }

  /** The pose of the body's origin at the last finished step. */
  pose(): Pose {
    const { p, q } = this.poseInBullet();
    return { p: add(p, this.#node.world.poses.origin), q };
  }

  /** The same, seen from Bullet's origin. */
  poseInBullet(): Pose {
    const at = this.#node.slot * POSE;
    const c = this.#node.world.poses.current;
    return {
      p: [c[at]!, c[at + 1]!, c[at + 2]!],
      q: [c[at + 3]!, c[at + 4]!, c[at + 5]!, c[at + 6]!],
    };
  }

  #inBullet({ p, q }: Pose): Pose {
    return { p: subtract(p, this.#node.world.poses.origin), q };
  }

  /** Puts the body there at once. Joints hang on to where an immovable body is put. */
  place(pose: Pose): void {
    this.placeInBullet(this.#inBullet(pose));
  }

  /** The same, seen from Bullet's origin. */
  placeInBullet(own: Pose): void {
    const { world, body, slot, centerOfMass, movable, joints } = this.#node;
    const center = compose(own, centerOfMass);
    // setWorldTransform would leave the world inertia tensor and the interpolation pose behind.
    body.setCenterOfMassTransform(world.engine.scratch.transform(center.p, center.q));
    world.rays.moved();
    world.poses.current.set([...own.p, ...own.q], slot * POSE);
    world.poses.snap(slot);
    if (!movable && joints.size > 0) world.registry.find(jointSolve)?.carried(this.#node);
  }

  moveTo(pose: Pose): void {
    const node = this.#node;
    if (!node.built) {
      this.start = pose;
      return;
    }
    this.loadChanges();
    const { world } = node;
    wakeTouching(world, world.registry, node);
    if (this.kinematic) {
      // It goes no further on its way.
      world.registry.find(carrying)?.release(node);
      this.standStill();
    }
    const velocity = this.velocityAtOrigin();
    this.place(pose);
    world.registry.find(gyroscopic)?.forget(node);
    if (node.centerOfMass.p.some(Boolean)) this.setVelocityAtOrigin(velocity);
    node.wake();
    // What never wakes is to be drawn there all the same.
    world.work();
  }

  /**
   * Where the author or an event puts it. A fixed body that is moved along is kinematic meanwhile, so that it pushes
   * others instead of jumping through them; a leap it makes as a jump.
   */
  carryTo(pose: Pose): void {
    const node = this.#node;
    const distance = length(subtract(pose.p, this.pose().p));
    // Without that code it is the only body: there is nothing that it could push.
    const jumps = distance > LONGEST_CARRY || !contacts.here;
    if (node.fresh || node.movable || !node.active || jumps) {
      this.moveTo(pose);
      return;
    }
    const from = compose(this.poseInBullet(), node.centerOfMass);
    const to = compose(this.#inBullet(pose), node.centerOfMass);
    node.world.registry.get(carrying).carry(node, from, to);
    this.place(pose);
  }

  /** It is kinematic from now on. */
  goAlong(): void {
    const node = this.#node;
    this.kinematic = true;
    node.object.setFlags();
    keepAwake(node.body);
  }

  /** Carried no longer: static again. */
  standStill(): void {
    const node = this.#node;
    if (!node.built || node.movable) return;
    this.kinematic = false;
    node.object.setFlags();
    // As Bullet itself has immovable bodies: two of them are then not tested against each other.
    putToSleep(node.body);
    this.place(this.pose());
  }

  centerOfMassWorld(): Vec3 {
    return compose(this.pose(), this.#node.centerOfMass).p;
  }

  // ---- velocity ---------------------------------------------------------------------------------------------------

  #arm(): Vec3 {
    return rotate(this.pose().q, this.#node.centerOfMass.p);
  }

  velocityAtOrigin(): Velocity {
    const [vx, vy, vz, wx, wy, wz] = this.#node.world.bodies.velocityOf(this.#node);
    const angular: Vec3 = [wx!, wy!, wz!];
    return { linear: subtract([vx!, vy!, vz!], cross(angular, this.#arm())), angular };
  }

  /** The same, where joints hold it too: of the end of the step, not of its middle. */
  velocityShown(): Velocity {
    const { world } = this.#node;
    const now = world.registry.find(jointSolve)?.velocityOf(this.#node);
    if (!now) return this.velocityAtOrigin();
    const { velocities: v, at } = now;
    const angular: Vec3 = [v[at + 3]!, v[at + 4]!, v[at + 5]!];
    return {
      linear: subtract([v[at]!, v[at + 1]!, v[at + 2]!], cross(angular, this.#arm())),
      angular,
    };
  }

  /** It is about to be pushed, struck or turned otherwise than before. */
  loadChanges(): void {
    const node = this.#node;
    if (node.built && node.joints.size + node.ties.size > 0)
      node.world.registry.find(jointSolve)?.loadChanges(node);
  }

  setVelocityAtOrigin({ linear, angular }: Velocity): void {
    const { world, body } = this.#node;
    this.loadChanges();
    const { scratch } = world.engine;
    body.setLinearVelocity(scratch.vector(...add(linear, cross(angular, this.#arm()))));
    body.setAngularVelocity(scratch.vector(...angular));
    world.registry.find(jointSolve)?.relaunch(this.#node);
    world.bodies.readVelocity(this.#node);
  }

  updateVelocity(part: 'linearVelocity' | 'angularVelocity'): void {
    const node = this.#node;
    if (!node.movable) return;
    this.loadChanges();
    const velocity = this.velocityAtOrigin();
    const value = [...node.asked<Vec3>(part)] as Vec3;
    this.setVelocityAtOrigin(
      part === 'linearVelocity' ? { ...velocity, linear: value } : { ...velocity, angular: value },
    );
    node.wake();
  }
}
