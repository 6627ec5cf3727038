/**
 * Byte offsets inside Bullet 2.82's objects as ammojs-typed 1.1.0 lays them out (measured; the classes are not
 * 16-aligned in this build), proved by tests (`test/core/engine/layout.ts`): files of the package come with the one ammo.wasm
 * that their glue can read. Nothing else may name a number.
 */
export const BODY = {
  /** Rows of the rotation matrix, 16 bytes apart; the origin follows. */
  basis: 4,
  origin: 52,
  /** Its btDbvtProxy, while it stands in a world. */
  proxy: 188,
  shape: 192,
  collisionFlags: 204,
  islandTag: 208,
  activationState: 216,
  /** Bullet leaves it to its users: the body's number in `SolveOrder`. */
  rank: 240,
  linearVelocity: 312,
  angularVelocity: 328,
  inverseMass: 344,
  inverseInertiaLocal: 396,
  totalForce: 412,
  totalTorque: 428,
} as const;

/** Bytes of btCollisionShape. */
export const SHAPE = { type: 4 } as const;

/** BroadphaseNativeTypes of the shapes that are made here. */
export const SHAPE_TYPE = {
  box: 0,
  hull: 4,
  sphere: 8,
  cone: 11,
  cylinder: 13,
  mesh: 21,
  movingMesh: 25,
  compound: 31,
} as const;

/** Bytes of btGeneric6DofConstraint. */
export const SIX_DOF = {
  /** Its frame from the centre of mass of each body: the rows of a matrix, 16 bytes apart, then the origin. */
  frameA: 48,
  frameB: 112,
  linearLower: 680,
  linearUpper: 696,
  /** Of the first of three angles, its upper limit behind it; and what lies between two of them. */
  angularLower: 868,
  angularSize: 64,
  useLinearReferenceFrameA: 1300,
  /** Whether each body is pushed at its own frame's origin. */
  useOffsetForConstraintFrame: 1301,
} as const;

/** Bytes of btDiscreteDynamicsWorld: its arrays, its btDispatcherInfo, whose time step comes first, and its btContactSolverInfo. */
export const WORLD = {
  objectCount: 8,
  objects: 16,
  dispatchInfo: 28,
  broadphase: 68,
  solverInfo: 92,
  islands: 204,
  constraintCount: 212,
  constraints: 220,
} as const;

/** Bytes of btSimulationIslandManager: the elements of its union-find, a root and the number of an object each. */
export const ISLANDS = { count: 8, elements: 16 } as const;

/** Bytes of btDbvtProxy: what tells pairs apart, the node of the tree that it is a leaf of, and the list that it stands in. */
export const PROXY = {
  body: 0,
  groups: 4,
  id: 12,
  leaf: 48,
  before: 52,
  after: 56,
  list: 60,
} as const;

/** Bytes of btDbvtNode: both corners of its box, a number each 4 bytes, what it hangs on, and what it is the leaf of. */
export const LEAF = { low: 0, high: 16, parent: 32, proxy: 36 } as const;

/** Bytes of btDbvtBroadphase: the tree of what moved, and its lists of proxies, the last one that of what did not. */
export const BROADPHASE = {
  moving: 4,
  /** In a tree, whose root comes first: how many leaves it has. */
  leaves: 12,
  lists: 124,
  list: 144,
  /** Percent of all pairs that a step looks at, whether they are still near each other. */
  cleanup: 156,
  /** One byte each: who comes is to be compared with all others in the next step; pairs may have gone. */
  deferred: 193,
  stale: 194,
} as const;

/** Bytes of btContactSolverInfo. */
export const SOLVER = {
  timeStep: 12,
  iterations: 20,
  errorReduction: 32,
  errorReduction2: 36,
  splitImpulseThreshold: 48,
  linearSlop: 56,
  warmstarting: 60,
  mode: 64,
} as const;

/** Of btSequentialImpulseConstraintSolver: how many functions at least, and two of them. */
export const SOLVER_VTABLE = { count: 14, prepareSolve: 2, allSolved: 4 } as const;

/**
 * Of btDiscreteDynamicsWorld: how many functions, `internalSingleStepSimulation`, and the stages that this consists of, in
 * their order.
 */
export const WORLD_VTABLE = {
  count: 45,
  step: 40,
  stages: [
    35, // predictUnconstraintMotion: world, seconds
    11, // performDiscreteCollisionDetection: world
    37, // calculateSimulationIslands: world
    38, // solveConstraints: world, settings of its solver
    36, // integrateTransforms: world, seconds
    39, // updateActivationState: world, seconds
  ],
} as const;

/** btContactSolverInfo::m_solverMode bits. */
export const SOLVER_MODE = {
  warmstart: 4,
  twoFrictionDirections: 16,
  /** Friction acts along the directions that stand in the contact point, where its flag says so. */
  cachedFrictionDirections: 32,
  simd: 256,
} as const;

export const MANIFOLD_POINT = {
  /** Of both positions, each in the frame of its own body. */
  localA: 0,
  localB: 16,
  positionB: 32,
  positionA: 48,
  normalB: 64,
  distance: 80,
  friction: 84,
  rollingFriction: 88,
  restitution: 92,
  part0: 96,
  part1: 100,
  index0: 104,
  index1: 108,
  /** Bullet leaves it to its users. */
  corner: 112,
  directionsGiven: 116,
  impulse: 120,
  lateralImpulse1: 124,
  lateralImpulse2: 128,
  motion1: 132,
  motion2: 136,
  direction1: 152,
  direction2: 168,
  size: 184,
} as const;

/** Bytes of btCollisionDispatcher: the array of its manifolds. */
export const DISPATCHER = { manifoldCount: 12, manifolds: 20 } as const;

/** Points that a manifold holds. */
export const MOST_POINTS = 4;

/** Bytes of btPersistentManifold: the points are its first member. */
export const MANIFOLD = {
  points: 4,
  bodyA: 740,
  bodyB: 744,
  pointCount: 748,
  /** How far a point may move and still be the same, metres. */
  breaking: 752,
  /** Its place in the dispatcher's array. */
  index: 768,
} as const;

/** btCollisionObject::m_activationState1. */
export const ACTIVATION = {
  sleeping: 2,
  alwaysActive: 4,
} as const;

/** btCollisionObject::m_collisionFlags. */
export const COLLISION_FLAG = { static: 1, kinematic: 2, noResponse: 4 } as const;

/** btRigidBody::m_rigidbodyFlags. */
export const RIGID_BODY_FLAG = { ownGravity: 1 } as const;

/** btTypedConstraint::setParam numbers. */
export const CONSTRAINT_PARAM = { erp: 1, stopErp: 2, cfm: 3, stopCfm: 4 } as const;
