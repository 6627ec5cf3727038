import { add, rotate, scale, type Pose } from '../../physics-core/base/math.js';
import type { CaseBody, CaseScene, Quaternion, Vec3 } from '../case.js';
import { forceOn, guideOf, isRound, massOf, momentsOf, poseOf, torqueOn } from './bodies.js';
import { NotOffered, type Running } from './engine.js';
import { constraintOf, drive, type Jolt } from './jolt-joints.js';
import { fieldOf, hullOf, meshOf } from './jolt-surfaces.js';
import type { End, Plan, Push } from './joints.js';

type Body = InstanceType<Jolt['Body']>;
type JVec3 = InstanceType<Jolt['Vec3']>;
type System = InstanceType<Jolt['PhysicsSystem']>;

/** Jolt holds bodies to 47 rad/s by default. */
const MAX_SPIN = 1e4;

/** Object layers, each a layer of the broad phase too. */
const STILL = 0;
export const MOVING = 1;
/** Touches nothing. */
const LOOSE = 2;
const LAYERS = 3;

const xyz = (v: { GetX(): number; GetY(): number; GetZ(): number }): Vec3 => [
  v.GetX(),
  v.GetY(),
  v.GetZ(),
];
const xyzw = (q: InstanceType<Jolt['Quat']>): Quaternion => [
  q.GetX(),
  q.GetY(),
  q.GetZ(),
  q.GetW(),
];

/** Of edges: Jolt's own, where the shape is large enough for it. */
const roundness = (...halves: number[]): number => Math.min(0.05, ...halves.map((r) => r / 2));

/** A scene in Jolt. */
export class JoltScene {
  readonly jolt: Jolt;
  readonly bodies = new Map<string, Body>();
  readonly interface: InstanceType<Jolt['JoltInterface']>;
  readonly system: System;
  readonly forces: (() => void)[] = [];
  readonly moves: ((dt: number) => void)[] = [];
  readonly #scene: CaseScene;
  readonly #made: object[] = [];
  /** Which bodies are joined, and so don't collide. */
  readonly #joined: InstanceType<Jolt['GroupFilterTable']>;

  constructor(jolt: Jolt, scene: CaseScene) {
    this.jolt = jolt;
    this.#scene = scene;
    this.interface = this.own(new jolt.JoltInterface(this.#settings()));
    this.system = this.interface.GetPhysicsSystem();
    this.system.SetGravity(this.vec(scene.gravity));
    this.#joined = new jolt.GroupFilterTable(scene.bodies.length);
  }

  own<T extends object>(object: T): T {
    this.#made.push(object);
    return object;
  }

  vec([x, y, z]: Vec3): JVec3 {
    return this.own(new this.jolt.Vec3(x, y, z));
  }

  place([x, y, z]: Vec3) {
    return this.own(new this.jolt.RVec3(x, y, z));
  }

  /** The interface takes the filters over, and destroys them. */
  #settings() {
    const { jolt } = this;
    const pairs = new jolt.ObjectLayerPairFilterTable(LAYERS);
    pairs.EnableCollision(STILL, MOVING);
    pairs.EnableCollision(MOVING, MOVING);
    const phases = new jolt.BroadPhaseLayerInterfaceTable(LAYERS, LAYERS);
    for (let layer = 0; layer < LAYERS; layer++)
      phases.MapObjectToBroadPhaseLayer(layer, this.own(new jolt.BroadPhaseLayer(layer)));
    const settings = this.own(new jolt.JoltSettings());
    settings.mMaxWorkerThreads = 0;
    settings.mObjectLayerPairFilter = pairs;
    settings.mBroadPhaseLayerInterface = phases;
    settings.mObjectVsBroadPhaseLayerFilter = new jolt.ObjectVsBroadPhaseLayerFilterTable(
      phases,
      LAYERS,
      pairs,
      LAYERS,
    );
    return settings;
  }

  // ---- bodies -------------------------------------------------------------------------------------------------------

  #shape({ shape, fixed }: CaseBody): InstanceType<Jolt['Shape']> {
    const { jolt } = this;
    if (!shape) return new jolt.SphereShape(0.1);
    if (shape.type === 'IndexedTriangleSet')
      return fixed ? meshOf(this, shape) : hullOf(this, shape);
    if (shape.type === 'ElevationGrid') return fieldOf(this, shape);
    if (shape.type === 'Sphere') return new jolt.SphereShape(shape.radius);
    if (shape.type === 'Cylinder') {
      const { radius, height } = shape;
      return new jolt.CylinderShape(height / 2, radius, roundness(radius, height / 2));
    }
    const half = scale(shape.size, 0.5);
    return new jolt.BoxShape(this.vec(half), roundness(...half));
  }

  /** Jolt's place of a body is that of its shape. */
  #shapeOf(body: CaseBody): InstanceType<Jolt['Shape']> {
    const { offset } = body;
    const made = this.#shape(body);
    if (!offset) return made;
    return new this.jolt.OffsetCenterOfMassShape(made, this.vec(scale(offset, -1)));
  }

  #layer(body: CaseBody): number {
    if (!this.#scene.contact || !body.shape) return LOOSE;
    return body.fixed && !guideOf(body) ? STILL : MOVING;
  }

  #motion(body: CaseBody) {
    const { jolt } = this;
    if (guideOf(body)) return jolt.EMotionType_Kinematic;
    return body.fixed ? jolt.EMotionType_Static : jolt.EMotionType_Dynamic;
  }

  add(body: CaseBody): void {
    const { jolt } = this;
    const { p, q } = poseOf(body);
    const settings = this.own(
      new jolt.BodyCreationSettings(
        this.#shapeOf(body),
        this.place(body.offset ? add(p, rotate(q, body.offset)) : p),
        this.own(new jolt.Quat(...q)),
        this.#motion(body),
        this.#layer(body),
      ),
    );
    settings.mFriction = this.#scene.contact?.friction ?? 0;
    settings.mRestitution = this.#scene.contact?.bounce ?? 0;
    settings.mCollisionGroup = this.own(new jolt.CollisionGroup(this.#joined, 0, this.bodies.size));
    if (!body.fixed) this.#move(settings, body);
    const guide = guideOf(body);
    if (guide) settings.mAllowSleeping = false;
    const made = this.system.GetBodyInterface().CreateBody(settings);
    this.system.GetBodyInterface().AddBody(made.GetID(), jolt.EActivation_Activate);
    this.bodies.set(body.name, made);
    if (guide) this.#carry(made, guide);
    if (!body.fixed) this.#push(made, this.vec(forceOn(body)), this.vec(torqueOn(body)));
    if (body.pull) this.#pull(made, body.pull);
  }

  #move(settings: InstanceType<Jolt['BodyCreationSettings']>, body: CaseBody): void {
    const { jolt } = this;
    settings.mAllowSleeping = false;
    settings.mApplyGyroscopicForce = true;
    settings.mMaxAngularVelocity = MAX_SPIN;
    settings.mLinearVelocity = this.vec(body.linearVelocity ?? [0, 0, 0]);
    settings.mAngularVelocity = this.vec(body.angularVelocity ?? [0, 0, 0]);
    settings.mGravityFactor = body.useGlobalGravity === false ? 0 : 1;
    settings.mOverrideMassProperties = jolt.EOverrideMassProperties_MassAndInertiaProvided;
    settings.mMassPropertiesOverride.mMass = massOf(body);
    const moments = momentsOf(body);
    settings.mMassPropertiesOverride.mInertia = jolt.Mat44.prototype.sScaleVec3(this.vec(moments));
    settings.mLinearDamping = body.autoDamp ? (body.linearDampingFactor ?? 0) / massOf(body) : 0;
    settings.mAngularDamping = body.autoDamp ? (body.angularDampingFactor ?? 0) / moments[0] : 0;
    if (settings.mAngularDamping > 0 && !isRound(body))
      throw new NotOffered('angular drag of a body that is not round');
  }

  /** Along with its author's path: to where that ends after the step. */
  #carry(body: Body, guide: (time: number) => Pose): void {
    const bodies = this.system.GetBodyInterface();
    const [to, turn] = [this.place([0, 0, 0]), this.own(new this.jolt.Quat(0, 0, 0, 1))];
    let steps = 0;
    this.moves.push((dt) => {
      const { p, q } = guide(++steps * dt);
      to.Set(...p);
      turn.Set(...q);
      bodies.MoveKinematic(body.GetID(), to, turn, dt);
    });
  }

  /** Jolt forgets forces after each step. */
  #push(body: Body, force: JVec3, torque: JVec3): void {
    if (force.Length() > 0) this.forces.push(() => body.AddForce(force));
    if (torque.Length() > 0) this.forces.push(() => body.AddTorque(torque));
  }

  #pull(body: Body, pull: (at: Vec3) => Vec3): void {
    const force = this.vec([0, 0, 0]);
    this.forces.push(() => {
      force.Set(...pull(xyz(body.GetCenterOfMassPosition())));
      body.AddForce(force);
    });
  }

  // ---- joints -------------------------------------------------------------------------------------------------------

  #at({ body }: End): Body {
    return body === undefined ? this.interface.sGetFixedToWorldBody() : this.bodies.get(body)!;
  }

  /** Jolt counts the turn and the way of its second body against its first. */
  join(plan: Plan): void {
    const [b, a] = plan.ends;
    const settings = this.own(constraintOf(this, plan));
    const constraint = settings.Create(this.#at(a), this.#at(b));
    this.system.AddConstraint(constraint);
    if (plan.motor) drive(this.jolt, constraint, plan.motor);
    const names = [...this.bodies.keys()];
    const [one, other] = [names.indexOf(a.body ?? ''), names.indexOf(b.body ?? '')];
    if (one >= 0 && other >= 0) this.#joined.DisableCollision(one, other);
  }

  /** What page code has to do in each step. */
  push({ kind, body1, body2, vector }: Push): void {
    const [one, other] = [this.bodies.get(body1)!, body2 ? this.bodies.get(body2)! : undefined];
    const now = this.vec([0, 0, 0]);
    const apply = (body: Body) => (kind === 'force' ? body.AddForce(now) : body.AddTorque(now));
    this.forces.push(() => {
      const [x, y, z] = rotate(xyzw(one.GetRotation()), vector);
      now.Set(x, y, z);
      apply(one);
      if (!other) return;
      now.Set(-x, -y, -z);
      apply(other);
    });
  }

  // ---- running ------------------------------------------------------------------------------------------------------

  set iterations(iterations: number) {
    const settings = this.system.GetPhysicsSettings();
    settings.mNumVelocitySteps = iterations;
    this.system.SetPhysicsSettings(settings);
  }

  running(step: number): Running {
    const seen =
      <T>(look: (body: Body) => T) =>
      (name: string): T =>
        look(this.bodies.get(name)!);
    return {
      timeStep: step,
      step: () => {
        for (const move of this.moves) move(step);
        for (const apply of this.forces) apply();
        this.interface.Step(step, 1);
      },
      position: seen((body) => xyz(body.GetCenterOfMassPosition())),
      orientation: seen((body) => xyzw(body.GetRotation())),
      linearVelocity: seen((body) => xyz(body.GetLinearVelocity())),
      angularVelocity: seen((body) => xyz(body.GetAngularVelocity())),
      // Jolt tells its contacts to a listener only, which would slow it down.
      contacts: () => null,
      effects: () => [],
      destroy: () => this.destroy(),
    };
  }

  destroy(): void {
    for (const object of this.#made.reverse()) this.jolt.destroy(object);
  }
}
