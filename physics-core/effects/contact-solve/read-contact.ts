import { hypot } from '../../base/exact/index.js';
import { cross3 } from '../../base/flat-math.js';
import type { Ammo } from '../../engine/ammo.js';
import { originOf } from '../../engine/body-heap.js';
import { ContactPoint } from '../../engine/contact-point.js';
import { readVelocity } from '../../engine/heap.js';
import { isCarried } from '../../engine/solver-body.js';
import { ALONG } from '../drag/slips.js';
import { C, speeds, type ConeContacts } from '../../solver/rows/cone-contacts.js';
import type { TouchingBodies } from './touching-bodies.js';
import { SIZE } from '../../solver/matrix/block-cholesky.js';
import { BAND, ROUGH_STIFFNESS } from '../../solver/tolerances.js';

/** Bullet's solver leaves out what lies farther away, metres. */
export const LEFT_OUT = 1e18;

/** What a miss costs, in effective masses of the contact: more takes more matrices, less more rounds (measured). */
const STIFFNESS = 1e3;

/** Share of an overlap that goes in a step: gently where it is shallow, and else as Bullet's own. */
const SHARE = 0.2;
const SHALLOW = 1e-3;
const PUSH_SHARE = 0.8;

/**
 * Where contacts are gone over one at a time, one may be off by so much, either way, and go on bearing what it bore, metres:
 * they contradict each other by as much. Let go of or pushed apart at once, loads wander from one to the next, and heaps
 * creep by half a millimetre a second (measured).
 */
const SWEPT_BAND = 3e-5;

/** What a contact point needs to know of the step. */
export interface ContactStep {
  dt: number;
  /** Depth that resting contacts keep, metres. */
  slop: number;
  /** They are gone over one at a time. */
  swept: boolean;
  /** Their part is solved roughly. */
  rough: boolean;
  /** Points whose distance was written for the solver, by pointer. */
  written: ReadonlySet<number>;
}

/** Takes contact points from Bullet, and gives them what was found. */
export class ContactPort {
  readonly #ammo: Ammo;
  readonly #bodies: TouchingBodies;
  readonly #contacts: ConeContacts;
  readonly #point: ContactPoint;
  /** Velocity of a body that is carried. */
  readonly #carried = new Float64Array(6);
  readonly #way = new Float64Array(3);
  readonly #turned = new Float64Array(3);
  readonly #swing = new Float64Array(3);

  constructor(ammo: Ammo, bodies: TouchingBodies, contacts: ConeContacts) {
    this.#ammo = ammo;
    this.#bodies = bodies;
    this.#contacts = contacts;
    this.#point = new ContactPoint(ammo);
  }

  /** The number of the contact; -1: it is left out. `p` and `q`: numbers of the bodies at `a` and `b`. */
  read(pointer: number, a: number, b: number, p: number, q: number, step: ContactStep): number {
    const point = this.#point.at(pointer, a, b);
    if (point.solverDistance > LEFT_OUT) return -1;
    const at = this.#contacts.add(pointer, p, q);
    const c = this.#contacts.values;
    this.#readPlace(c, at, a, b);
    this.#readDirections(c, at);
    c[at + C.friction] = point.friction;
    c[at + C.penalty] = (step.rough ? ROUGH_STIFFNESS : STIFFNESS) * this.#mass(p, q);
    this.#readTargets(c, at, p, q, step);
    c[at + C.corner] = point.corner;
    this.#readCarried(c, at, a, b, p, q, step.dt);
    return this.#contacts.count - 1;
  }

  #readPlace(c: Float64Array, at: number, a: number, b: number): void {
    const point = this.#point;
    for (let k = 0; k < 3; k++) {
      c[at + C.normal + k] = point.normal(k);
      const here = (point.positionOnA(k) + point.position(k)) / 2;
      c[at + C.armA + k] = here - originOf(this.#ammo, a, k);
      c[at + C.armB + k] = here - originOf(this.#ammo, b, k);
    }
  }

  /** Directions of friction, the impulses that the last step had along them, and the speeds that they aim at. */
  #readDirections(c: Float64Array, at: number): void {
    const point = this.#point;
    const given = point.directionsGiven;
    if (!given) layAsBullet(c, at);
    let along1 = 0;
    let along2 = 0;
    for (let k = 0; k < 3; k++) {
      if (given) {
        c[at + C.direction1 + k] = point.direction(0, k);
        c[at + C.direction2 + k] = point.direction(1, k);
      }
      const rub = point.lateralPush(k);
      along1 += rub * c[at + C.direction1 + k]!;
      along2 += rub * c[at + C.direction2 + k]!;
    }
    c[at + C.impulse] = point.impulse;
    c[at + C.impulse + 1] = along1;
    c[at + C.impulse + 2] = along2;
    c[at + C.target + 1] = given ? point.motion(0) : 0;
    c[at + C.target + 2] = given ? point.motion(1) : 0;
  }

  #mass(a: number, b: number): number {
    const { masses } = this.#bodies;
    return 1 / ((a < 0 ? 0 : 1 / masses[a]!) + (b < 0 ? 0 : 1 / masses[b]!));
  }

  #readTargets(c: Float64Array, at: number, p: number, q: number, step: ContactStep): void {
    const { pointer, solverDistance, restitution } = this.#point;
    const asked = step.written.has(pointer);
    const gap = this.#gapOf(solverDistance + step.slop, step.swept);
    const share = asked || gap < -SHALLOW ? PUSH_SHARE : SHARE;
    c[at + C.target] = gap > 0 ? -gap / step.dt : 0;
    c[at + C.overlap] = gap < 0 ? -gap * share : 0;
    c[at + C.approach] = c[at + C.back] = c[at + C.driven] = 0;
    for (let k = 1; k < 3; k++) c[at + C.driven + k] = c[at + C.target + k]!;
    if (restitution === 0) return;
    // Of the approach before forces act, as Bullet has it.
    speeds(c, at, this.#bodies.velocities, p, q, C.miss);
    const back = -restitution * c[at + C.miss]!;
    if (back <= 0) return;
    c[at + C.approach] = c[at + C.miss]!;
    c[at + C.target] = c[at + C.back] = back;
    c[at + C.overlap] = 0;
  }

  /** What is to be closed, or is less than it should be, metres. */
  #gapOf(gap: number, swept: boolean): number {
    const sunk = swept ? SWEPT_BAND : 0;
    const risen = this.#point.impulse > 0 ? sunk : 0;
    return gap > Math.max(BAND, risen) ? gap - risen : Math.min(0, gap + sunk);
  }

  /** What its author moves has a speed, though nothing pushes it. */
  #readCarried(
    c: Float64Array,
    at: number,
    a: number,
    b: number,
    p: number,
    q: number,
    dt: number,
  ): void {
    const carried = p < 0 ? a : q < 0 ? b : 0;
    if (carried === 0 || !isCarried(this.#ammo, carried)) return;
    readVelocity(this.#ammo, carried, this.#carried, 0);
    this.#leadCarried(c, at, p, q, dt);
    speeds(c, at, this.#carried, p < 0 ? 0 : -1, p < 0 ? -1 : 0, C.miss);
    for (let k = 0; k < 3; k++) {
      c[at + C.target + k]! -= c[at + C.miss + k]!;
      c[at + C.driven + k]! -= c[at + C.miss + k]!;
    }
  }

  /**
   * What turns goes elsewhere otherwise, so what rolls or slides over it meets it at the end of the step where it has got
   * to by then. What goes along with it is taken along as it is (`Riders`).
   */
  #leadCarried(c: Float64Array, at: number, p: number, q: number, dt: number): void {
    const v = this.#carried;
    if (v[3] === 0 && v[4] === 0 && v[5] === 0) return;
    const [arm, own, rider] = p < 0 ? [C.armB, C.armA, q] : [C.armA, C.armB, p];
    const by = this.#way;
    const turned = this.#turned;
    const swing = this.#swing;
    // Of the contact against the middle of what is carried, and of the place on that which it leaves, m/s.
    cross3(turned, 0, v, 3, c, at + arm);
    for (let k = 0; k < 3; k++)
      by[k] = this.#bodies.velocities[rider * SIZE + k]! + turned[k]! - v[k]!;
    cross3(turned, 0, v, 3, c, at + own);
    cross3(swing, 0, v, 3, turned, 0);
    let slips = 0;
    for (let k = 0; k < 3; k++) slips += (by[k]! - turned[k]! + dt * swing[k]!) ** 2;
    if (slips < ALONG ** 2) return;
    cross3(turned, 0, v, 3, by, 0);
    for (let k = 0; k < 3; k++) v[k]! += dt * turned[k]!;
  }

  /** What was found, where sensors look for it and the next step begins. */
  write(i: number): void {
    const c = this.#contacts.values;
    const at = i * C.size;
    const point = this.#point.at(this.#contacts.pointers[i]!, 0, 0);
    const first = at + C.direction1;
    const second = at + C.direction2;
    point.impulse = c[at + C.impulse]!;
    point.setLateralImpulses(c[at + C.impulse + 1]!, c[at + C.impulse + 2]!);
    point.setDirection(0, c[first]!, c[first + 1]!, c[first + 2]!);
    point.setDirection(1, c[second]!, c[second + 1]!, c[second + 2]!);
  }
}

/**
 * Both directions as Bullet has them in a point that it finds anew: it keeps the impulses along them, and forgets what was
 * written there. Along others, friction would begin each step turned aside.
 */
function layAsBullet(c: Float64Array, at: number): void {
  const x = c[at]!;
  const y = c[at + 1]!;
  const z = c[at + 2]!;
  const facesZ = Math.abs(z) > Math.SQRT1_2;
  const size = facesZ ? hypot(y, z) : hypot(x, y);
  const p = at + C.direction1;
  c[p] = facesZ ? 0 : -y / size;
  c[p + 1] = facesZ ? -z / size : x / size;
  c[p + 2] = facesZ ? y / size : 0;
  cross3(c, at + C.direction2, c, at, c, p);
}
