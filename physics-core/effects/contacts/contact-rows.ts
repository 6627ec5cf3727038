import { hypot } from '../../base/exact/index.js';
import type { ContactPoint } from '../../engine/contact-point.js';
import type { Vec3 } from '../../fields/types.js';
import type { Body } from '../../dynamics/body.js';
import { isDirected, type ContactParameters } from '../../dynamics/contact-parameters.js';
import { layInSurface } from './friction-directions.js';

/** A distance at which Bullet leaves a contact point out of its solver; the pair filter takes points farther away, metres. */
export const FAR = 1e25;

/** Below this the surfaces stick, and there is no direction of sliding, m/s. */
const STICKING = 1e-6;

/** Slip above so many times what one step at most takes from the speed, dt / mass, is a great one. */
const SLIPPERY = 10;

/** A pair of bodies for Bullet, as manifolds have them. */
export interface Pair {
  a: Body;
  b: Body;
  /** Undefined: they differ from collidable to collidable. Null: contacts wait for set_contacts. */
  parameters: ContactParameters | null | undefined;
  /** Those already looked up, by the number of both parts. */
  byParts: Map<number, ContactParameters | null>;
  /** Where the changes of the velocities of A and B stand. */
  atA: number;
  atB: number;
  /** What A got from B in the last step, all points together, N s. */
  impulse: Float64Array;
  /** The step it was summed up in. */
  summed: number;
  /** How deep softness may let it overlap, metres; known once it is asked for. */
  deepest: number | undefined;
  /** 1: A is body1 of a Contact, which is carried along by surface speed; -1: B is. */
  carried: 1 | -1;
}

/** What a point needs to know of the step. */
export interface StepState {
  dt: number;
  /** Depth that resting contacts keep, metres. */
  slop: number;
  /** Greatest speed of pushing overlaps apart, m/s. */
  maxCorrectionSpeed: number;
  /** What the last step did to every body's linear velocity. */
  changes: Float64Array;
}

/** The point is not there for the solver. */
export function leaveOut(point: ContactPoint): void {
  point.solverDistance = FAR;
  point.impulse = 0;
}

/** Friction, bounce, and with directions also surface speed and slip. */
export function writeSurface(
  point: ContactPoint,
  pair: Pair,
  parameters: ContactParameters,
  step: StepState,
): void {
  const { bounce, friction } = parameters;
  point.friction = Math.max(friction[0], friction[1]);
  point.restitution = 0;
  if (bounce > 0) writeBounce(point, parameters);
  point.directionsGiven = false;
  if (isDirected(parameters)) directions.write(point, pair, parameters, step);
}

/**
 * Bullet solves contacts before bodies touch, and brakes the approach that should come back: what bounces is left
 * alone until then (measured).
 */
function writeBounce(point: ContactPoint, { bounce, minBounceSpeed }: ContactParameters): void {
  if (point.solverDistance > 0) {
    leaveOut(point);
    return;
  }
  const approach = -point.speed(point.normal(0), point.normal(1), point.normal(2));
  if (approach >= minBounceSpeed) point.restitution = bounce;
}

/**
 * The speed along (x, y, z) that the step would lead to without the force between the two bodies, if all else goes on as
 * in the last step. The force is that of all their points together: among themselves Bullet shares it out by chance.
 * What it did to the spins cancels out, and to count it makes boxes rock (measured).
 */
export function freeSpeed(
  point: ContactPoint,
  { impulse, atA, atB }: Pair,
  changes: Float64Array,
  x: number,
  y: number,
  z: number,
): number {
  const m = point.inverseMass;
  return (
    point.speed(x, y, z) +
    x * (changes[atA]! - changes[atB]! - m * impulse[0]!) +
    y * (changes[atA + 1]! - changes[atB + 1]! - m * impulse[1]!) +
    z * (changes[atA + 2]! - changes[atB + 2]! - m * impulse[2]!)
  );
}

/** Friction along two directions of the surface, each with its own limit, speed and slip. */
class Directions {
  readonly first = new Float64Array(3);
  readonly #second = new Float64Array(3);

  write(point: ContactPoint, pair: Pair, parameters: ContactParameters, step: StepState): void {
    const { friction, speed, slip } = parameters;
    this.lay(point, parameters.direction);
    this.#across(point, pair.carried);
    const same = friction[0] === friction[1] && slip[0] === 0 && slip[1] === 0;
    if (same && this.#alongSliding(point, pair, speed)) return;
    const least = point.inverseMass * step.dt * SLIPPERY;
    const first = this.#limit(point, pair, parameters, step.dt, 0, least);
    const second = this.#limit(point, pair, parameters, step.dt, 1, least);
    const most = Math.max(first, second) || 1;
    point.friction = most;
    this.#row(point, pair, parameters, step, 0, first / most, slip[0] <= least);
    this.#row(point, pair, parameters, step, 1, second / most, slip[1] <= least);
    point.directionsGiven = true;
  }

  lay(point: ContactPoint, given: Vec3 | undefined): void {
    layInSurface(this.first, point.normal(0), point.normal(1), point.normal(2), given);
  }

  /** Direction 2, so that the two and the normal into body1 are x, z and y on a floor. */
  #across(point: ContactPoint, carried: number): void {
    const first = this.first;
    const second = this.#second;
    for (let i = 0; i < 3; i++) {
      const j = (i + 1) % 3;
      const k = (i + 2) % 3;
      second[i] = (first[j]! * point.normal(k) - first[k]! * point.normal(j)) * carried;
    }
  }

  /** Equal friction all round: one direction follows the sliding, so that it is a circle and not a square. */
  #alongSliding(point: ContactPoint, pair: Pair, speed: readonly [number, number]): boolean {
    const first = this.first;
    const second = this.#second;
    const motion1 = speed[0] * pair.carried;
    const motion2 = speed[1] * pair.carried;
    const u = point.speed(first[0]!, first[1]!, first[2]!) - motion1;
    const v = point.speed(second[0]!, second[1]!, second[2]!) - motion2;
    const size = hypot(u, v);
    if (size < STICKING) return false;
    const c = u / size;
    const s = v / size;
    this.#turned(point, 0, c, first, s, second);
    this.#turned(point, 1, c, second, -s, first);
    point.setMotion(0, c * motion1 + s * motion2);
    point.setMotion(1, c * motion2 - s * motion1);
    // The impulses of the last step lay along other directions.
    point.setLateralImpulses(0, 0);
    point.directionsGiven = true;
    return true;
  }

  /** c a + s b becomes one of the directions. */
  #turned(
    point: ContactPoint,
    which: 0 | 1,
    c: number,
    a: Float64Array,
    s: number,
    b: Float64Array,
  ): void {
    point.setDirection(which, c * a[0]! + s * b[0]!, c * a[1]! + s * b[1]!, c * a[2]! + s * b[2]!);
  }

  /**
   * Coulomb's coefficient of a row. Of what slips much, friction is known from the speed: it takes a load that small
   * from the coefficient, since a speed to aim at would make it buzz (measured).
   */
  #limit(
    point: ContactPoint,
    { impulse, carried }: Pair,
    { friction, speed, slip }: ContactParameters,
    dt: number,
    which: 0 | 1,
    least: number,
  ): number {
    if (slip[which] <= least) return friction[which];
    const [x, y, z] = which === 0 ? this.first : this.#second;
    const push =
      impulse[0]! * point.normal(0) + impulse[1]! * point.normal(1) + impulse[2]! * point.normal(2);
    const sliding = Math.abs(point.speed(x!, y!, z!) - speed[which] * carried);
    return push > 0 ? Math.min(friction[which], (sliding * dt) / (slip[which] * push)) : 0;
  }

  /**
   * Bullet has one coefficient for both rows, and takes the direction of a row as it is: a shorter one has less
   * friction, in the same share (measured). Slip is X3D's sliding speed per force; Bullet's own lets go of anything
   * that slips, so the speed that it leads to is worked out here.
   */
  #row(
    point: ContactPoint,
    pair: Pair,
    { speed, slip }: ContactParameters,
    { dt, changes }: StepState,
    which: 0 | 1,
    share: number,
    aims: boolean,
  ): void {
    const [x, y, z] = which === 0 ? this.first : this.#second;
    const motion = speed[which] * pair.carried;
    let aim = motion;
    if (aims && slip[which] > 0) {
      const free = freeSpeed(point, pair, changes, x!, y!, z!);
      aim += ((free - motion) * slip[which]) / (slip[which] + point.inverseMass * dt);
    }
    point.setDirection(which, x! * share, y! * share, z! * share);
    point.setMotion(which, aim * share);
  }
}

const directions = new Directions();
