import { FRAME, perStep } from '../../dynamics/levels.js';
import type { ContactPoint } from '../../engine/contact-point.js';
import type { ContactParameters } from '../../dynamics/contact-parameters.js';
import { FAR, freeSpeed, type Pair, type StepState } from './contact-rows.js';
import { isJointed } from '../../dynamics/jointed.js';

/** Share of an overlap that Bullet pushes apart per step without adding velocity (its own m_erp2). */
const PUSH_SHARE = 0.8;

/**
 * The same per 1/60 s where bodies with joints bounce: a push takes them off their joints, which make a speed of it
 * (measured: 18 % more than a ball of a cradle has; so 1 %).
 */
const JOINTED_PUSH_SHARE = 0.1;

/** Softness ends where so much of the thinner body is overlapped: deeper, and it could come out on the other side. */
const DEEPEST = 0.25;

/**
 * How fast a soft contact comes back, as a share of its spring's own pace: faster, and two in a stack disturb each
 * other (measured).
 */
const RETURN = 0.2;

/**
 * How fast an overlap goes. X3D's contact is a spring and a damper in one: the surfaces part at
 * share · depth / dt - softness · force. Bullet's has no force in it, so the speed is worked out here, from what the
 * point would do without its own force, and goes into the distance that Bullet sees: a positive one lets the surfaces
 * near each other further, a negative one pushes them apart without adding velocity.
 */
export function writeDepth(
  point: ContactPoint,
  pair: Pair,
  parameters: ContactParameters,
  step: StepState,
): void {
  const depth = -point.distance - step.slop;
  const { dt } = step;
  const { errorCorrection, softness } = parameters;
  if ((depth <= 0 && softness === 0) || point.solverDistance >= FAR) return;
  const share = errorCorrection === undefined ? usualShare(pair, dt) : perStep(errorCorrection, dt);
  let speed = Math.min((share * Math.max(0, depth)) / dt, step.maxCorrectionSpeed);
  if (softness > 0) {
    speed = softened(point, pair, parameters, step, speed);
    speed = Math.max(speed, Math.min((depth - deepest(pair)) / dt, step.maxCorrectionSpeed));
  }
  const gap = Math.max(0, -depth);
  const distance = speed > 0 ? (-speed * dt) / PUSH_SHARE : gap - speed * dt;
  point.solverDistance = distance - step.slop;
}

const usualShare = (pair: Pair, dt: number): number =>
  isJointedPair(pair) ? perStep(JOINTED_PUSH_SHARE, dt) : PUSH_SHARE;

/** Whether the joint solve moves one of them. */
export const isJointedPair = ({ a, b }: Pair): boolean => isJointed(a) || isJointed(b);

/** How deep softness may let a pair overlap, metres. */
const deepest = (pair: Pair): number =>
  (pair.deepest ??= DEEPEST * Math.min(pair.a.leastExtent, pair.b.leastExtent));

/** The speed at which softness lets the surfaces part, where a hard contact would do so at `hard`. */
function softened(
  point: ContactPoint,
  pair: Pair,
  { softness, errorCorrection }: ContactParameters,
  { dt, changes }: StepState,
  hard: number,
): number {
  const x = point.normal(0);
  const y = point.normal(1);
  const z = point.normal(2);
  const e = errorCorrection!;
  const share = perStep(e, dt);
  // So that the depth under a load is the same at every level: force · softness / (60 · share).
  const yielding = softness * (e > 0 ? (share * FRAME) / (dt * e) : 1);
  const ease = point.inverseMass * dt;
  const free = freeSpeed(point, pair, changes, x, y, z);
  const wanted = hard + (free * yielding) / ease;
  if (wanted <= 0) return (wanted * ease) / (yielding + ease);
  // Bullet pushes apart without velocity, so what comes up gathers no speed: its pace is that of the spring.
  const spring = Math.sqrt((ease * share) / yielding);
  return Math.max(0, wanted * Math.min(1, (RETURN * spring) / share) - Math.max(0, free));
}
