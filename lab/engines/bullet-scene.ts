import { fetchGlue, loadAmmo, type Ammo } from '../../physics-core/engine/ammo.js';
import { Owner } from '../../physics-core/engine/owner.js';
import { cross, quaternionOfAxes, rotate, type Pose } from '../../physics-core/base/math.js';
import type { CaseBody, CaseScene, Quaternion, Shape, Vec3 } from '../case.js';
import { forceOn, guideOf, massOf, poseOf, torqueOn } from './bodies.js';
import type { Running } from './engine.js';
import { fieldOf, hullOf, meshOf } from './bullet-surfaces.js';
import type { End, Plan, Plans, Push } from './joints.js';

export type BtBody = Ammo['btRigidBody']['prototype'];
export type BtShape = Ammo['btCollisionShape']['prototype'];
export type BtConstraint = Ammo['btTypedConstraint']['prototype'];
type BtVector = Ammo['btVector3']['prototype'];

/** How somebody who uses Bullet makes bodies and joints of what a case says. */
export interface Ways {
  shape(scene: BulletScene, body: CaseBody): BtShape;
  moments(scene: BulletScene, body: CaseBody, shape: BtShape): Vec3;
  /** Of each of two alike bodies; Bullet multiplies them. */
  material(contact: { bounce: number; friction: number }): { bounce: number; friction: number };
  /** Bullet's own damping: the share of its speed that a body loses in a second. */
  damping(body: CaseBody): { linear: number; angular: number };
  joint(scene: BulletScene, plan: Plan): BtConstraint;
}

const xyz = (v: BtVector): Vec3 => [v.x(), v.y(), v.z()];

function turnOf(body: BtBody): Quaternion {
  const q = body.getWorldTransform().getRotation();
  return [q.x(), q.y(), q.z(), q.w()];
}

/** Collision flag of a body that its author moves. */
const KINEMATIC = 2;

/** Activation state of a body that never sleeps. */
const ALWAYS_AWAKE = 4;

let loading: Promise<Ammo> | undefined;

/** As its package has it: ours may have no more of it than the core calls. */
export const allOfAmmo = (): Promise<Ammo> =>
  (loading ??= fetchGlue().then((glue) => loadAmmo(glue, undefined)));

/** A scene in Ammo, as made by hand: Bullet's default settings, motion states, one shape per body. */
export class BulletScene {
  readonly ammo: Ammo;
  readonly owner: Owner;
  readonly world: Ammo['btDiscreteDynamicsWorld']['prototype'];
  readonly bodies = new Map<string, BtBody>();
  readonly #dispatcher: Ammo['btCollisionDispatcher']['prototype'];
  readonly #ground: BtBody;
  readonly #constraints: BtConstraint[] = [];
  readonly #scene: CaseScene;
  readonly #ways: Ways;
  readonly #forced: (() => void)[] = [];
  readonly #moved: ((time: number) => void)[] = [];
  #steps = 0;

  static async make(scene: CaseScene, ways: Ways, plans: Plans): Promise<BulletScene> {
    const made = new BulletScene(await allOfAmmo(), scene, ways);
    try {
      for (const joint of plans.joints) made.#addJoint(joint);
      for (const push of plans.pushes) made.#addPush(push);
    } catch (error) {
      made.destroy();
      throw error;
    }
    return made;
  }

  private constructor(ammo: Ammo, scene: CaseScene, ways: Ways) {
    this.ammo = ammo;
    this.owner = new Owner(ammo);
    this.#scene = scene;
    this.#ways = ways;
    const configuration = this.owner.own(new ammo.btDefaultCollisionConfiguration());
    this.#dispatcher = this.owner.own(new ammo.btCollisionDispatcher(configuration));
    this.world = this.owner.own(
      new ammo.btDiscreteDynamicsWorld(
        this.#dispatcher,
        this.owner.own(new ammo.btDbvtBroadphase()),
        this.owner.own(new ammo.btSequentialImpulseConstraintSolver()),
        configuration,
      ),
    );
    this.world.setGravity(this.vector(scene.gravity));
    this.#ground = this.#make({ name: 'the world', fixed: true });
    for (const body of scene.bodies) this.#add(body);
  }

  vector([x, y, z]: Vec3): BtVector {
    return this.owner.own(new this.ammo.btVector3(x, y, z));
  }

  // ---- bodies -----------------------------------------------------------------------------------------------------

  primitive(shape: Shape, moves = true): BtShape {
    const { ammo } = this;
    if (shape.type === 'ElevationGrid') return fieldOf(this, shape);
    if (shape.type === 'IndexedTriangleSet')
      return moves ? hullOf(this, shape) : meshOf(this, shape);
    const made = (): BtShape => {
      if (shape.type === 'Sphere') return new ammo.btSphereShape(shape.radius);
      if (shape.type === 'Box')
        return new ammo.btBoxShape(this.vector(shape.size.map((length) => length / 2) as Vec3));
      const { radius, height } = shape;
      return new ammo.btCylinderShape(this.vector([radius, height / 2, radius]));
    };
    return this.owner.own(made());
  }

  /** Of one shape. */
  compound(shape: Shape, offset: Vec3 = [0, 0, 0]): BtShape {
    const made = this.owner.own(new this.ammo.btCompoundShape());
    this.put(made, this.primitive(shape), offset);
    return made;
  }

  put(into: Ammo['btCompoundShape']['prototype'], part: BtShape, at: Vec3): void {
    into.addChildShape(this.transform({ p: at, q: [0, 0, 0, 1] }), part);
  }

  #make(body: CaseBody): BtBody {
    const { ammo, owner } = this;
    const shape = body.shape
      ? this.#ways.shape(this, body)
      : owner.own(new ammo.btSphereShape(0.1));
    const moving = !body.fixed;
    const moments = moving ? this.#ways.moments(this, body, shape) : [0, 0, 0];
    const motion = owner.own(new ammo.btDefaultMotionState(this.transform(poseOf(body))));
    const info = owner.own(
      new ammo.btRigidBodyConstructionInfo(
        moving ? massOf(body) : 0,
        motion,
        shape,
        this.vector(moments as Vec3),
      ),
    );
    return owner.own(new ammo.btRigidBody(info));
  }

  transform({ p, q }: Pose) {
    const made = this.owner.own(new this.ammo.btTransform());
    made.setIdentity();
    made.setOrigin(this.vector(p));
    made.setRotation(this.owner.own(new this.ammo.btQuaternion(...q)));
    return made;
  }

  #add(body: CaseBody): void {
    const { contact } = this.#scene;
    const made = this.#make(body);
    this.bodies.set(body.name, made);
    made.setActivationState(ALWAYS_AWAKE);
    made.setLinearVelocity(this.vector(body.linearVelocity ?? [0, 0, 0]));
    made.setAngularVelocity(this.vector(body.angularVelocity ?? [0, 0, 0]));
    if (contact) {
      const { bounce, friction } = this.#ways.material(contact);
      made.setRestitution(bounce);
      made.setFriction(friction);
    }
    if (body.autoDamp) {
      const { linear, angular } = this.#ways.damping(body);
      made.setDamping(linear, angular);
    }
    const guide = guideOf(body);
    if (guide) this.#carry(made, guide);
    // Without contacts: in group 1, colliding with group 0.
    if (contact && body.shape) this.world.addRigidBody(made);
    else this.world.addRigidBody(made, 1, 0);
    if (body.useGlobalGravity === false) made.setGravity(this.vector([0, 0, 0]));
    this.#push(made, forceOn(body), torqueOn(body));
    if (body.pull) this.#pull(made, body.pull);
  }

  /** Bullet takes the pose of what is kinematic from its motion state, and its speed from how far that went. */
  #carry(body: BtBody, guide: (time: number) => Pose): void {
    body.setCollisionFlags(KINEMATIC);
    const to = this.transform(guide(0));
    const turn = this.owner.own(new this.ammo.btQuaternion(0, 0, 0, 1));
    this.#moved.push((time) => {
      const { p, q } = guide(time);
      to.getOrigin().setValue(...p);
      turn.setValue(...q);
      to.setRotation(turn);
      body.getMotionState().setWorldTransform(to);
    });
  }

  /** What is moved goes to where it is to be after a step of `dt` seconds. */
  moveOn(dt: number): void {
    this.#steps++;
    for (const move of this.#moved) move(this.#steps * dt);
  }

  #push(body: BtBody, force: Vec3, torque: Vec3): void {
    const [f, t] = [this.vector(force), this.vector(torque)];
    if (force.some(Boolean)) this.#forced.push(() => body.applyCentralForce(f));
    if (torque.some(Boolean)) this.#forced.push(() => body.applyTorque(t));
  }

  #pull(body: BtBody, pull: (at: Vec3) => Vec3): void {
    const force = this.vector([0, 0, 0]);
    this.#forced.push(() => {
      force.setValue(...pull(xyz(body.getWorldTransform().getOrigin())));
      body.applyCentralForce(force);
    });
  }

  // ---- joints -----------------------------------------------------------------------------------------------------

  at({ body }: End): BtBody {
    return body === undefined ? this.#ground : this.bodies.get(body)!;
  }

  /** A frame at an end, with its axis as x or z. */
  frame({ anchor, axis, normal }: End, axisIs: 'x' | 'z') {
    const [x, z] = axisIs === 'x' ? [axis, normal] : [normal, axis];
    return this.transform({ p: anchor, q: quaternionOfAxes(x, cross(z, x), z) });
  }

  #addJoint(plan: Plan): void {
    const constraint = this.owner.own(this.#ways.joint(this, plan));
    // Joined bodies don't collide.
    this.world.addConstraint(constraint, true);
    this.#constraints.push(constraint);
  }

  /** What page code has to do in each step. */
  #addPush({ kind, body1, body2, vector }: Push): void {
    const [one, other] = [this.bodies.get(body1)!, body2 ? this.bodies.get(body2)! : undefined];
    const now = this.vector([0, 0, 0]);
    const apply = (body: BtBody) =>
      kind === 'force' ? body.applyCentralForce(now) : body.applyTorque(now);
    this.#forced.push(() => {
      const [x, y, z] = rotate(turnOf(one), vector);
      now.setValue(x, y, z);
      apply(one);
      if (!other) return;
      now.setValue(-x, -y, -z);
      apply(other);
    });
  }

  /** Bullet forgets forces after each `stepSimulation`. */
  applyForces(): void {
    for (const apply of this.#forced) apply();
  }

  // ---- running ----------------------------------------------------------------------------------------------------

  running(timeStep: number, step: () => void): Running {
    const seen =
      <T>(look: (body: BtBody) => T) =>
      (name: string): T =>
        look(this.bodies.get(name)!);
    return {
      timeStep,
      step,
      position: seen((body) => xyz(body.getWorldTransform().getOrigin())),
      orientation: seen(turnOf),
      linearVelocity: seen((body) => xyz(body.getLinearVelocity())),
      angularVelocity: seen((body) => xyz(body.getAngularVelocity())),
      contacts: () => this.#contacts(),
      effects: () => [],
      destroy: () => this.destroy(),
    };
  }

  #manifolds(): Ammo['btPersistentManifold']['prototype'][] {
    return Array.from({ length: this.#dispatcher.getNumManifolds() }, (_, i) =>
      this.#dispatcher.getManifoldByIndexInternal(i),
    );
  }

  #contacts(): number {
    return this.#manifolds().reduce((sum, manifold) => sum + manifold.getNumContacts(), 0);
  }

  /** Metres between surfaces in each contact point that the last step found; negative where they overlap. */
  distances(): number[] {
    return this.#manifolds().flatMap((manifold) =>
      Array.from({ length: manifold.getNumContacts() }, (_, i) =>
        manifold.getContactPoint(i).getDistance(),
      ),
    );
  }

  destroy(): void {
    for (const constraint of this.#constraints) this.world.removeConstraint(constraint);
    for (const body of this.bodies.values()) this.world.removeRigidBody(body);
    this.owner.dispose();
  }
}
