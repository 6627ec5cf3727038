import type { Ammo } from './ammo.js';
import type { Engine } from './engine.js';
import type { BtBody } from './heap.js';
import { isAwake } from './body-state.js';
import { keeping } from './keeping.js';
import type { KeptWorld } from './kept-world.js';
import { DISPATCHER, MANIFOLD, SOLVER, SOLVER_MODE } from './offsets.js';
import { forgetImpulses, pointAt, pointCountAt } from './manifold.js';
import { Owner } from './owner.js';
import type { SolveOrder } from './solve-order.js';

export type BtConstraint = Ammo['btTypedConstraint']['prototype'];

/** What a level sets in Bullet's solver. */
export interface SolverSettings {
  iterations: number;
  /** Friction acts along the directions that stand in contact points, where they say so. */
  givenFrictionDirections: boolean;
  /** Two rows of friction per contact point instead of one. */
  twoFrictionDirections: boolean;
  /** Depth (metres, negative) above which contacts correct position without adding velocity. */
  splitImpulseThreshold: number;
  /** Share of a shallow overlap that contacts repair per step, by velocity. */
  contactErrorReduction: number;
  /** Depth that resting contacts keep, metres. */
  linearSlop: number;
  /** Whether contacts may be solved directly. */
  direct: boolean;
  /** Blocks of matrices that a step may spend on what touches and moves. */
  effort: number;
  /** Share of its speed that what hangs together and touches may miss by. */
  miss: number;
}

const modeOf = ({ givenFrictionDirections, twoFrictionDirections }: SolverSettings): number =>
  SOLVER_MODE.warmstart |
  SOLVER_MODE.simd |
  (givenFrictionDirections ? SOLVER_MODE.cachedFrictionDirections : 0) |
  (twoFrictionDirections ? SOLVER_MODE.twoFrictionDirections : 0);

/** A ball of 1 m that stands in no world yet. */
export function makeImmovable({ ammo, scratch }: Engine, owner: Owner): BtBody {
  const shape = owner.own(new ammo.btSphereShape(1));
  const nothing = scratch.vector(0, 0, 0);
  const info = owner.own(new ammo.btRigidBodyConstructionInfo(0, null as never, shape, nothing));
  return owner.own(new ammo.btRigidBody(info));
}

/** Bullet's dynamics world with its solver settings. Bodies and constraints are owned by their nodes. */
export class BulletWorld {
  readonly engine: Engine;
  readonly bullet: Ammo['btDiscreteDynamicsWorld']['prototype'];
  /** An immovable body that joints with one body hold on to; it stands in no world. */
  readonly ground: BtBody;
  readonly #owner: Owner;
  readonly #dispatcher: Ammo['btCollisionDispatcher']['prototype'];
  readonly #solver: number;
  #order: SolveOrder | undefined;
  /** Ids by pointers, of what came before there was an order. */
  readonly #early = { bodies: new Map<number, number>(), constraints: new Map<number, number>() };
  readonly #broadphase: number;
  #kept: KeptWorld | undefined;
  #meshesMove = false;
  settings!: SolverSettings;

  constructor(engine: Engine) {
    const { ammo } = engine;
    this.engine = engine;
    this.#owner = new Owner(ammo);
    const configuration = this.#owner.own(new ammo.btDefaultCollisionConfiguration());
    this.#dispatcher = this.#owner.own(new ammo.btCollisionDispatcher(configuration));
    const broadphase = this.#owner.own(new ammo.btDbvtBroadphase());
    const solver = this.#owner.own(new ammo.btSequentialImpulseConstraintSolver());
    this.bullet = this.#owner.own(
      new ammo.btDiscreteDynamicsWorld(this.#dispatcher, broadphase, solver, configuration),
    );
    this.ground = makeImmovable(engine, this.#owner);
    // Every body carries its own collection's gravity.
    this.bullet.setGravity(engine.scratch.vector(0, 0, 0));
    this.#broadphase = ammo.getPointer(broadphase);
    engine.solverHook.attach(ammo.getPointer(solver));
    engine.stages.attach(ammo.getPointer(this.bullet));
    this.#solver = ammo.getPointer(this.bullet.getSolverInfo());
  }

  /** Undefined: there is nothing to solve. */
  get order(): SolveOrder | undefined {
    return (this.#order ??= this.#makeOrder());
  }

  #makeOrder(): SolveOrder | undefined {
    const { ammo } = this.engine;
    const world = ammo.getPointer(this.bullet);
    const order = keeping.orderOf?.(ammo, world, ammo.getPointer(this.#dispatcher));
    if (!order) return undefined;
    for (const [pointer, id] of this.#early.bodies) order.addBody(pointer, id);
    for (const [pointer, id] of this.#early.constraints) order.addConstraint(pointer, id);
    return order;
  }

  /** What it keeps from step to step beside bodies; undefined: nothing touches. */
  get kept(): KeptWorld | undefined {
    return (this.#kept ??= this.order && keeping.of?.(this, this.#broadphase));
  }

  configure(settings: SolverSettings): void {
    this.settings = settings;
    this.bullet.getSolverInfo().set_m_numIterations(settings.iterations);
    const { ammo } = this.engine;
    ammo.HEAP32[(this.#solver + SOLVER.mode) >> 2] = modeOf(settings);
    ammo.HEAPF32[(this.#solver + SOLVER.splitImpulseThreshold) >> 2] =
      settings.splitImpulseThreshold;
    ammo.HEAPF32[(this.#solver + SOLVER.errorReduction) >> 2] = settings.contactErrorReduction;
    ammo.HEAPF32[(this.#solver + SOLVER.linearSlop) >> 2] = settings.linearSlop;
  }

  /** Bullet has no answer to two meshes meeting until its algorithm for moving ones is registered. */
  allowMovingMeshes(): void {
    if (this.#meshesMove) return;
    this.#meshesMove = true;
    const { ammo } = this.engine;
    const { btGImpactCollisionAlgorithm: algorithm } = ammo;
    // A static function in C++, which Ammo offers as a method: whose it is does not matter.
    ammo
      .wrapPointer(ammo.getPointer(this.#dispatcher), algorithm)
      .registerAlgorithm(this.#dispatcher);
  }

  /** One exact step: `maxSubSteps` 0 makes Bullet take the given time as it is. */
  step(seconds: number): void {
    this.order?.arrange();
    this.bullet.stepSimulation(seconds, 0);
  }

  /** Between steps: finds what is near each other and where it touches, as a step does first. */
  findPairs(): void {
    this.engine.stages.collide(this.engine.ammo.getPointer(this.bullet));
  }

  /**
   * Calls `visit` for every pair that may touch. `awakeOnly`: those that Bullet's solver looks at; `touchingOnly`: those with
   * contact points, of a crowd one in a hundred (measured), of whose others not even the bodies are looked at.
   */
  eachPair(
    visit: (manifold: number, a: number, b: number) => void,
    awakeOnly = false,
    touchingOnly = false,
  ): void {
    const { ammo } = this.engine;
    const dispatcher = ammo.getPointer(this.#dispatcher);
    const count = ammo.HEAP32[(dispatcher + DISPATCHER.manifoldCount) >> 2]!;
    for (let i = 0; i < count; i++) {
      const { HEAP32 } = ammo;
      const manifold = HEAP32[(HEAP32[(dispatcher + DISPATCHER.manifolds) >> 2]! >> 2) + i]!;
      if (touchingOnly && HEAP32[(manifold + MANIFOLD.pointCount) >> 2] === 0) continue;
      const a = HEAP32[(manifold + MANIFOLD.bodyA) >> 2]!;
      const b = HEAP32[(manifold + MANIFOLD.bodyB) >> 2]!;
      if (!awakeOnly || isAwake(ammo, a) || isAwake(ammo, b)) visit(manifold, a, b);
    }
  }

  eachAwakeManifold(visit: (manifold: number, a: number, b: number) => void): void {
    this.eachPair(visit, true);
  }

  /** Those of them that have contact points. */
  eachAwakeTouching(visit: (manifold: number, a: number, b: number) => void): void {
    this.eachPair(visit, true, true);
  }

  /** Whether any two bodies touch, asleep or not. */
  get anyTouching(): boolean {
    const { HEAP32 } = this.engine.ammo;
    const dispatcher = this.engine.ammo.getPointer(this.#dispatcher);
    const count = HEAP32[(dispatcher + DISPATCHER.manifoldCount) >> 2]!;
    const first = HEAP32[(dispatcher + DISPATCHER.manifolds) >> 2]! >> 2;
    for (let i = 0; i < count; i++)
      if (HEAP32[(HEAP32[first + i]! + MANIFOLD.pointCount) >> 2] !== 0) return true;
    return false;
  }

  /**
   * Calls `visit` for each pair of a body that has contact points, with the other one's pointer. A pair of others costs
   * nanoseconds: an edit in a large scene costs no more than in a small one.
   */
  eachTouching(body: number, visit: (other: number, manifold: number) => void): void {
    const { ammo } = this.engine;
    const { bodyA, bodyB, pointCount } = MANIFOLD;
    const dispatcher = ammo.getPointer(this.#dispatcher);
    const { HEAP32 } = ammo;
    const count = HEAP32[(dispatcher + DISPATCHER.manifoldCount) >> 2]!;
    const first = HEAP32[(dispatcher + DISPATCHER.manifolds) >> 2]! >> 2;
    for (let i = 0; i < count; i++) {
      const manifold = HEAP32[first + i]!;
      const a = HEAP32[(manifold + bodyA) >> 2]!;
      const b = HEAP32[(manifold + bodyB) >> 2]!;
      if (a !== body && b !== body) continue;
      if (HEAP32[(manifold + pointCount) >> 2] !== 0) visit(a === body ? b : a, manifold);
    }
  }

  /**
   * What a body was pushed with in the last step no longer counts: Bullet starts its solver from that, and pushes that held
   * a hundred kilograms throw ten grams away (measured: 700 m/s).
   */
  forgetImpulsesOf(body: number): void {
    const { ammo } = this.engine;
    this.eachTouching(body, (_, manifold) => forgetImpulses(ammo, manifold));
  }

  /**
   * Visits each pair with contact points: the pointer of the first, which the others follow (`pointAfter`), how many, and
   * the pointers of both bodies.
   */
  eachTouchingPair(visit: (first: number, count: number, a: number, b: number) => void): void {
    const { ammo } = this.engine;
    this.eachPair(
      (manifold, a, b) => visit(pointAt(manifold, 0), pointCountAt(ammo, manifold), a, b),
      false,
      true,
    );
  }

  /** Contact points of all pairs. */
  get contactCount(): number {
    let points = 0;
    this.eachTouchingPair((_, count) => (points += count));
    return points;
  }

  get manifoldCount(): number {
    return this.#dispatcher.getNumManifolds();
  }

  /** `id`: the number of its node, which says where it comes in what is solved. */
  addBody(body: BtBody, id: number, group: number, mask: number): void {
    const pointer = this.engine.ammo.getPointer(body);
    this.order?.expectBody();
    this.bullet.addRigidBody(body, group, mask);
    if (this.order) this.order.addBody(pointer, id);
    else this.#early.bodies.set(pointer, id);
  }

  removeBody(body: BtBody): void {
    const pointer = this.engine.ammo.getPointer(body);
    this.#early.bodies.delete(pointer);
    this.order?.removeBody(pointer);
    this.bullet.removeRigidBody(body);
  }

  addConstraint(constraint: BtConstraint, id: number): void {
    const pointer = this.engine.ammo.getPointer(constraint);
    this.bullet.addConstraint(constraint, true);
    if (this.order) this.order.addConstraint(pointer, id);
    else this.#early.constraints.set(pointer, id);
  }

  removeConstraint(constraint: BtConstraint): void {
    const pointer = this.engine.ammo.getPointer(constraint);
    this.#early.constraints.delete(pointer);
    this.order?.removeConstraint(pointer);
    this.bullet.removeConstraint(constraint);
  }

  dispose(): void {
    this.#owner.dispose();
  }
}
