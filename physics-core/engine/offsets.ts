/**
 * Byte offsets inside Bullet 2.82's objects as ammojs-typed 1.1.0 lays them out (measured; the classes are not
 * 16-aligned in this build). `heap-check.ts` proves them against the API at load; nothing else may name a number.
 */
export const BODY = {
  /** Rows of the rotation matrix, 16 bytes apart; the origin follows. */
  basis: 4,
  origin: 52,
  islandTag: 208,
  activationState: 216,
  linearVelocity: 312,
  angularVelocity: 328,
  inverseMass: 344,
  inverseInertiaLocal: 396,
} as const;

export const SOLVER = {
  iterations: 20,
  errorReduction: 32,
  errorReduction2: 36,
  splitImpulseThreshold: 48,
  linearSlop: 56,
  warmstarting: 60,
  mode: 64,
} as const;

/** btContactSolverInfo::m_solverMode bits. */
export const SOLVER_MODE = {
  warmstart: 4,
  twoFrictionDirections: 16,
  simd: 256,
} as const;

export const MANIFOLD_POINT = {
  positionB: 32,
  normalB: 64,
  friction: 84,
  restitution: 92,
  index0: 104,
  index1: 108,
} as const;

/** btCollisionObject::m_activationState1. */
export const ACTIVATION = {
  active: 1,
  sleeping: 2,
  alwaysActive: 4,
} as const;

/** btCollisionObject::m_collisionFlags. */
export const COLLISION_FLAG = { static: 1, kinematic: 2, noResponse: 4 } as const;

/** btRigidBody::m_rigidbodyFlags. */
export const RIGID_BODY_FLAG = { ownGravity: 1 } as const;

/** btTypedConstraint::setParam numbers. */
export const CONSTRAINT_PARAM = { erp: 1, stopErp: 2, cfm: 3, stopCfm: 4 } as const;
