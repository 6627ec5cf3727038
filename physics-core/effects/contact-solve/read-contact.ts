import type { Ammo } from '../../engine/ammo.js';
import { BODY, COLLISION_FLAG, MANIFOLD_POINT as POINT } from '../../engine/offsets.js';
import { layInSurface } from '../contacts/friction-directions.js';
import { C, speeds, type ConeContacts } from './cone-contacts.js';
import type { SolveBodies } from './solve-bodies.js';

/** Bullet's solver leaves out what lies farther away, metres. */
export const LEFT_OUT = 1e18;

/** What a miss costs, in effective masses of the contact: more takes more matrices, less more rounds (measured). */
const STIFFNESS = 1e3;

/** Share of an overlap that goes in a step: gently where it is shallow, and else as Bullet's own. */
const SHARE = 0.2;
const SHALLOW = 1e-3;
const PUSH_SHARE = 0.8;

/**
 * By so much a contact may lie less deep than it should and still bear, metres: what stands on four legs would else stand
 * on three, as single precision has it.
 */
const BAND = 8e-6;

/** What a contact point needs to know of the step. */
export interface ContactStep {
  dt: number;
  /** Depth that resting contacts keep, metres. */
  slop: number;
  /** Points whose distance was written for the solver, by pointer. */
  written: ReadonlySet<number>;
}

/** Takes contact points from Bullet's heap, and gives them what was found. */
export class ContactPort {
  readonly #ammo: Ammo;
  readonly #bodies: SolveBodies;
  readonly #contacts: ConeContacts;
  readonly #laid = new Float64Array(3);
  /** Velocities of a body that is carried. */
  readonly #carried = new Float64Array(12);

  constructor(ammo: Ammo, bodies: SolveBodies, contacts: ConeContacts) {
    this.#ammo = ammo;
    this.#bodies = bodies;
    this.#contacts = contacts;
  }

  /** The number of the contact; -1: it is left out. `p` and `q`: numbers of the bodies at `a` and `b`. */
  read(point: number, a: number, b: number, p: number, q: number, step: ContactStep): number {
    const f = this.#ammo.HEAPF32;
    const distance = f[(point + POINT.distance) >> 2]!;
    if (distance > LEFT_OUT) return -1;
    const at = this.#contacts.add(point, p, q);
    const c = this.#contacts.values;
    this.#readPlace(c, at, point, a, b);
    c[at + C.friction] = f[(point + POINT.friction) >> 2]!;
    c[at + C.penalty] = STIFFNESS * this.#mass(p, q);
    this.#readTargets(c, at, point, p, q, distance, step);
    this.#readCarried(c, at, a, b, p, q);
    return this.#contacts.count - 1;
  }

  #readPlace(c: Float64Array, at: number, point: number, a: number, b: number): void {
    const f = this.#ammo.HEAPF32;
    const n = (point + POINT.normalB) >> 2;
    const onA = (point + POINT.positionA) >> 2;
    const onB = (point + POINT.positionB) >> 2;
    const given = this.#ammo.HEAP32[(point + POINT.directionsGiven) >> 2] !== 0;
    const first = (point + POINT.direction1) >> 2;
    const second = (point + POINT.direction2) >> 2;
    const x = f[n]!;
    const y = f[n + 1]!;
    const z = f[n + 2]!;
    const d = this.#laid;
    layInSurface(d, x, y, z, undefined);
    // What the last step found lies along the directions of then.
    const rub1 = f[(point + POINT.lateralImpulse1) >> 2]!;
    const rub2 = f[(point + POINT.lateralImpulse2) >> 2]!;
    let along1 = 0;
    let along2 = 0;
    for (let k = 0; k < 3; k++) {
      const next = (k + 1) % 3;
      const last = (k + 2) % 3;
      c[at + C.normal + k] = f[n + k]!;
      c[at + C.direction1 + k] = given ? f[first + k]! : d[k]!;
      c[at + C.direction2 + k] = given
        ? f[second + k]!
        : f[n + next]! * d[last]! - f[n + last]! * d[next]!;
      const here = (f[onA + k]! + f[onB + k]!) / 2;
      c[at + C.armA + k] = here - f[((a + BODY.origin) >> 2) + k]!;
      c[at + C.armB + k] = here - f[((b + BODY.origin) >> 2) + k]!;
      const rub = rub1 * f[first + k]! + rub2 * f[second + k]!;
      along1 += rub * c[at + C.direction1 + k]!;
      along2 += rub * c[at + C.direction2 + k]!;
    }
    c[at + C.impulse] = f[(point + POINT.impulse) >> 2]!;
    c[at + C.impulse + 1] = along1;
    c[at + C.impulse + 2] = along2;
    c[at + C.target + 1] = given ? f[(point + POINT.motion1) >> 2]! : 0;
    c[at + C.target + 2] = given ? f[(point + POINT.motion2) >> 2]! : 0;
  }

  #mass(a: number, b: number): number {
    const { masses } = this.#bodies;
    return 1 / ((a < 0 ? 0 : 1 / masses[a]!) + (b < 0 ? 0 : 1 / masses[b]!));
  }

  #readTargets(
    c: Float64Array,
    at: number,
    point: number,
    p: number,
    q: number,
    distance: number,
    { dt, slop, written }: ContactStep,
  ): void {
    const asked = written.has(point);
    const gap = distance + slop;
    c[at + C.depth] = -gap;
    c[at + C.target] = gap > BAND ? -gap / dt : 0;
    c[at + C.overlap] = gap < 0 ? -gap * (asked || gap < -SHALLOW ? PUSH_SHARE : SHARE) : 0;
    const restitution = this.#ammo.HEAPF32[(point + POINT.restitution) >> 2]!;
    if (restitution === 0) return;
    // Of the approach before forces act, as Bullet has it.
    speeds(c, at, this.#bodies.velocities, p, q, C.miss);
    const back = -restitution * c[at + C.miss]!;
    if (back <= 0) return;
    c[at + C.target] = back;
    c[at + C.depth] = 0;
    c[at + C.overlap] = 0;
  }

  /** What its author moves has a speed, though nothing pushes it. */
  #readCarried(c: Float64Array, at: number, a: number, b: number, p: number, q: number): void {
    const carried = p < 0 ? a : q < 0 ? b : 0;
    if (carried === 0 || !this.#isCarried(carried)) return;
    const f = this.#ammo.HEAPF32;
    const v = this.#carried;
    for (let k = 0; k < 3; k++) {
      v[k] = f[((carried + BODY.linearVelocity) >> 2) + k]!;
      v[3 + k] = f[((carried + BODY.angularVelocity) >> 2) + k]!;
    }
    speeds(c, at, v, p < 0 ? 0 : -1, p < 0 ? -1 : 0, C.miss);
    for (let k = 0; k < 3; k++) c[at + C.target + k]! -= c[at + C.miss + k]!;
  }

  #isCarried(body: number): boolean {
    return (this.#ammo.HEAP32[(body + BODY.collisionFlags) >> 2]! & COLLISION_FLAG.kinematic) !== 0;
  }

  /** What was found, where sensors look for it and the next step begins. */
  write(i: number): void {
    const f = this.#ammo.HEAPF32;
    const c = this.#contacts.values;
    const at = i * C.size;
    const point = this.#contacts.pointers[i]!;
    f[(point + POINT.impulse) >> 2] = c[at + C.impulse]!;
    f[(point + POINT.lateralImpulse1) >> 2] = c[at + C.impulse + 1]!;
    f[(point + POINT.lateralImpulse2) >> 2] = c[at + C.impulse + 2]!;
    for (let k = 0; k < 3; k++) {
      f[((point + POINT.direction1) >> 2) + k] = c[at + C.direction1 + k]!;
      f[((point + POINT.direction2) >> 2) + k] = c[at + C.direction2 + k]!;
    }
  }
}
