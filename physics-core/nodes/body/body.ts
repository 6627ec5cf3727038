import { identityPose, rotationOf, type Pose } from '../../base/math.js';
import type {
  Body,
  DragMode,
  Load,
  MassProperties,
  RestRule,
  Velocity,
} from '../../dynamics/body.js';
import { POSE } from '../../dynamics/poses.js';
import { contactReader } from '../../effects/contacts/effects.js';
import type { Drag } from '../../effects/drag/drag.js';
import type { DragEnd } from '../../effects/drag/hold.js';
import type { BodyChange } from '../../effects/effect/effect.js';
import type { BtBody } from '../../engine/heap.js';
import type { Rotation, Value, Vec3 } from '../../fields/types.js';
import type { CollidableNode, NodePart } from '../collision/collidable.js';
import type { NodeContext } from '../node/node-world.js';
import { PhysicsNode } from '../node/node.js';
import { BodyBuild } from './body-build.js';
import { BodyCommands, type Velocities } from './body-commands.js';
import type { BodyGeometry } from './body-geometry.js';
import { BodyGrip } from './body-grip.js';
import { BodyLoads } from './body-loads.js';
import { massOf } from './body-mass.js';
import { BodyMotion } from './body-motion.js';
import { BodyObject } from './body-object.js';
import { BodyPresence } from './body-presence.js';
import type { BodyJoint } from './body-joint.js';

/** A rigid body, put together from its parts. What people do to it is documented in face/nodes.ts. */
export class BodyNode extends PhysicsNode implements Body {
  /** -1 while the body is not built. */
  slot = -1;
  /** What a page moves with it: the page's own matter, as its host is. */
  drawn: unknown;
  readonly object = new BodyObject(this);
  readonly motion = new BodyMotion(this);
  readonly build = new BodyBuild(this);
  readonly loads = new BodyLoads(this);
  readonly presence = new BodyPresence(this);
  readonly grip = new BodyGrip(this);
  readonly geometry: BodyGeometry;
  readonly #commands = new BodyCommands(this);
  readonly joints = new Set<BodyJoint>();
  readonly ties = new Set<PhysicsNode>();

  mass: MassProperties = { mass: 1, moments: [0.4, 0.4, 0.4], centerOfMass: identityPose() };
  /** Centre of mass and principal axes in the body's frame. */
  centerOfMass: Pose = identityPose();
  isDynamic = false;
  rest: RestRule = { mode: 'library', time: 0, linearSpeed: 0, angularSpeed: 0 };
  /** Just created: the first round of patches finds everything in place already. */
  fresh = false;

  constructor(context: NodeContext, geometry: (body: BodyNode) => BodyGeometry) {
    super(context);
    this.geometry = geometry(this);
  }

  get body(): BtBody {
    return this.object.body;
  }

  get pointer(): number {
    return this.object.pointer;
  }

  get isObstacle(): boolean {
    return this.geometry.isObstacle;
  }

  protected override get counted(): boolean {
    return !this.isObstacle;
  }

  get standsFor(): PhysicsNode {
    return this.geometry.standsFor ?? this;
  }

  override get label(): string {
    return this.geometry.standsFor?.label ?? super.label;
  }

  get collidables(): readonly CollidableNode[] {
    return this.geometry.collidables;
  }

  get parts(): NodePart[] {
    return this.geometry.parts;
  }

  get solidParts(): BodyObject['solidParts'] {
    return this.object.solidParts;
  }

  get leastExtent(): number {
    return this.object.leastExtent;
  }

  get reach(): number {
    return this.object.reach;
  }

  // ---- life -------------------------------------------------------------------------------------------------------

  protected override create(): boolean {
    this.motion.start = this.geometry.begin(this.motion.start);
    this.presence.parked = false;
    this.fresh = true;
    this.slot = this.world.bodies.take(this);
    this.mass = massOf(this);
    this.centerOfMass = this.mass.centerOfMass;
    this.build.shapeChanges();
    this.object.make();
    this.world.bodies.register(this);
    this.motion.place(this.motion.startPose());
    return true;
  }

  /** By the numbers of joints: what adds up over them has the same bits, whichever was made anew. */
  addJoint(joint: BodyJoint): void {
    const later = [...this.joints].filter(({ id }) => id > joint.id);
    for (const other of later) this.joints.delete(other);
    for (const each of [joint, ...later]) this.joints.add(each);
  }

  protected override created(): void {
    this.fresh = false;
    this.world.registry.bodyMade(this);
    for (const joint of this.joints) joint.bodyReady();
  }

  protected override destroy(): void {
    const { world } = this;
    world.registry.find(contactReader)?.part(this, 'removed');
    this.presence.goOut();
    world.pairs.leave(this);
    world.registry.unmade(this);
    this.grip.withdraw();
    this.object.dispose();
    world.bodies.release(this);
    this.slot = -1;
  }

  protected override released(): void {
    this.geometry.release();
  }

  /** Moves under forces. */
  get movable(): boolean {
    return !this.grip.held && this.mayMove;
  }

  /** The same, when nobody holds it. */
  get mayMove(): boolean {
    return !this.asked<boolean>('fixed') && this.asked<number>('mass') > 0;
  }

  get kinematic(): boolean {
    return this.motion.kinematic;
  }

  // ---- in the world -----------------------------------------------------------------------------------------------

  get active(): boolean {
    return this.built && this.object.inWorld;
  }

  get settings(): PhysicsNode {
    return this.collection ?? this.world.settings;
  }

  /** Gravity, rest and who it collides with are those of its collection. */
  override belongTo(collection: PhysicsNode | undefined): void {
    super.belongTo(collection);
    for (const field of ['useGlobalGravity', 'autoDisable', 'dragMode']) this.touch(field);
    this.world.pairs.refreshBody(this);
  }

  /** Effects look at it again. While it is made nothing is said: they look once, at the end. */
  changed(change: BodyChange): void {
    if (!this.fresh) this.world.registry.bodyChanged(this, change);
  }

  // ---- what acts on it --------------------------------------------------------------------------------------------

  get gravity(): Vec3 {
    return this.loads.gravity;
  }

  get appliedGravity(): Vec3 {
    return this.loads.appliedGravity;
  }

  get constantLoad(): Load {
    return this.loads.constantLoad;
  }

  get angularDamping(): number {
    return this.loads.angularDamping;
  }

  get dampedShare(): BodyLoads['dampedShare'] {
    return this.loads.dampedShare;
  }

  get parked(): boolean {
    return this.presence.parked;
  }

  // ---- rest -------------------------------------------------------------------------------------------------------

  get sleeping(): boolean {
    return this.active && this.world.bodies.asleep(this) && this.movable;
  }

  wake(): void {
    this.#put('wake');
  }

  sleep(): void {
    this.#put('sleep');
  }

  #put(how: 'wake' | 'sleep'): void {
    const { events, bodies } = this.world;
    if (this.active && this.movable) events.call(this, how, [], () => bodies[how](this));
  }

  // ---- pose and velocity ------------------------------------------------------------------------------------------

  /** Before it is built a body is where it will start. */
  override get(name: string): Value {
    const value = super.get(name);
    if (this.built || !this.motion.start) return value;
    if (name === 'position') return this.motion.startPose().p;
    return name === 'orientation' ? rotationOf(this.motion.startPose().q) : value;
  }

  pose(): Pose {
    return this.motion.pose();
  }

  poseInBullet(): Pose {
    return this.motion.poseInBullet();
  }

  centerOfMassWorld(): Vec3 {
    return this.motion.centerOfMassWorld();
  }

  velocityAtOrigin(): Velocity {
    return this.motion.velocityAtOrigin();
  }

  setVelocityAtOrigin(velocity: Velocity): void {
    this.motion.setVelocityAtOrigin(velocity);
  }

  moveTo(pose: Pose): void {
    this.motion.moveTo(pose);
  }

  carryTo(pose: Pose): void {
    this.motion.carryTo(pose);
  }

  goAlong(): void {
    this.motion.goAlong();
  }

  standStill(): void {
    this.motion.standStill();
  }

  readPose(out: Float32Array | Float64Array | number[]): typeof out {
    const { poses } = this.world;
    const at = this.slot * POSE;
    for (let i = 0; i < POSE; i++) out[i] = this.slot < 0 ? 0 : poses.current[at + i]!;
    for (let i = 0; i < 3 && this.slot >= 0; i++) out[i]! += poses.origin[i]!;
    return out;
  }

  // ---- what page code does to it ----------------------------------------------------------------------------------

  teleport(position: Vec3, orientation?: Rotation, velocities: Partial<Velocities> = {}): void {
    this.world.events.call(this, 'teleport', [position, orientation, velocities], () =>
      this.#commands.teleport(position, orientation, velocities),
    );
  }

  applyForce(force: Vec3, at?: Vec3): void {
    this.world.events.call(this, 'applyForce', [force, at], () =>
      this.#commands.applyForce(force, at),
    );
  }

  applyTorque(torque: Vec3): void {
    this.world.events.call(this, 'applyTorque', [torque], () => this.#commands.applyTorque(torque));
  }

  applyImpulse(impulse: Vec3, at?: Vec3): void {
    this.world.events.call(this, 'applyImpulse', [impulse, at], () =>
      this.#commands.applyImpulse(impulse, at),
    );
  }

  argument<T>(method: string, type: 'SFVec3f' | 'SFRotation', value: unknown): T | undefined {
    return this.#commands.argument<T>(method, type, value);
  }

  get dragMode(): DragMode {
    return this.grip.mode;
  }

  get draggable(): boolean {
    return this.grip.draggable;
  }

  get offered(): boolean {
    return this.grip.offered;
  }

  drag(point: Vec3, onend: (reason: DragEnd) => void = () => {}): Drag | undefined {
    return this.world.events.call(this, 'drag', [point], () => this.grip.take(point, onend));
  }

  hold(held: boolean): void {
    this.grip.hold(held);
  }

  get size(): number {
    return this.built ? this.object.size : 0;
  }
}
