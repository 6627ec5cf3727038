import { backward, factor, forward, rowOf } from '../../base/cholesky.js';
import { cross3, dot3 } from '../../base/flat-math.js';
import { grown, grownInt } from '../../base/grown.js';
import { C, takePush, type ConeContacts } from '../rows/cone-contacts.js';
import type { Part } from '../part.js';
import type { SolveBodies } from '../solve-bodies.js';
import { SIZE } from '../matrix/block-cholesky.js';
import { BAND, FARTHEST_BUILT, LEVEL, MISS, SINGULAR } from '../tolerances.js';

/** Where what has been built to touch goes on from: in the middle of where it bears as it lies, metres. */
const BEARS = BAND / 2;

/** Bodies that say where they are. */
export interface PlacedBodies extends SolveBodies {
  /** One number of a centre of mass, metres. */
  originOf(body: number, k: number): number;
}

/**
 * What stands and was not in touch before begins with the impulses that its weight asks for. From the top down each body is
 * borne by what touches it from below, and hands its load on: pushes that keep every body where it is and that contacts can
 * give are a solution of the whole (the lower bound theorem of structures), and the search for one ends before its first
 * matrix. What so bears comes to where contacts bear at once, and not by falling there: what stands on twenty-five others
 * would have to go faster than it can. Where one body can't be borne so, but by friction or from aside, the part
 * begins with nothing.
 */
export class StandingStart {
  readonly #contacts: ConeContacts;
  readonly #bodies: PlacedBodies;
  /** The direction of the load of all. */
  readonly #down = new Float64Array(3);
  /** Of bodies: how far down each stands, the first of the contacts that bear it, and how far it goes down, metres. */
  #depths = new Float64Array(0);
  #first = new Int32Array(0);
  #ways = new Float64Array(0);
  /** Of contacts: the next one that bears the same body, and what a push of 1 N s gives that. */
  #next = new Int32Array(0);
  #wrenches = new Float64Array(0);
  /** Lower triangle of the sum of their squares. */
  readonly #sum = new Float64Array(rowOf(SIZE));
  readonly #asked = new Float64Array(SIZE);

  constructor(contacts: ConeContacts, bodies: PlacedBodies) {
    this.#contacts = contacts;
    this.#bodies = bodies;
  }

  /** Of a step of `dt` seconds where contacts keep a depth of `slop` metres. False: it begins with nothing. */
  begin({ bodies, contacts }: Part, dt: number, slop: number): boolean {
    if (!this.#isNew(bodies, contacts)) return false;
    // What contacts have to give goes to `momentum`, and is taken from it as they do.
    this.#bodies.gradient(bodies);
    if (!this.#readDepths(bodies)) return false;
    this.#sortContacts(bodies, contacts, (slop + FARTHEST_BUILT) / dt);
    const downwards = [...bodies].sort((a, b) => this.#depths[a]! - this.#depths[b]!);
    for (const body of downwards) this.#bear(body);
    if (!(this.#bodies.fastest(bodies) < MISS)) {
      this.#contacts.forget(contacts);
      return false;
    }
    for (let i = downwards.length - 1; i >= 0; i--) this.#close(downwards[i]!, dt);
    return true;
  }

  /** How far they go goes to `change`. */
  readWays({ bodies }: Part): void {
    const { change } = this.#bodies;
    for (const body of bodies)
      for (let k = 0; k < 3; k++) change[body * SIZE + k] = this.#ways[body]! * this.#down[k]!;
  }

  /** Nothing moves, and nothing has been borne. */
  #isNew(bodies: readonly number[], contacts: readonly number[]): boolean {
    const { velocities } = this.#bodies;
    for (const body of bodies)
      for (let k = body * SIZE; k < (body + 1) * SIZE; k++) if (velocities[k] !== 0) return false;
    const c = this.#contacts.values;
    for (const i of contacts) if (c[i * C.size + C.impulse] !== 0) return false;
    return true;
  }

  /** False: nothing pulls. */
  #readDepths(bodies: readonly number[]): boolean {
    const { momentum, count } = this.#bodies;
    if (this.#depths.length < count) {
      this.#depths = grown(this.#depths, 2 * count);
      this.#ways = grown(this.#ways, 2 * count);
      this.#first = grownInt(this.#first, 2 * count);
    }
    const down = this.#down.fill(0);
    for (const body of bodies) for (let k = 0; k < 3; k++) down[k]! -= momentum[body * SIZE + k]!;
    const load = Math.sqrt(dot3(down, 0, down, 0));
    for (let k = 0; k < 3; k++) down[k]! /= load;
    for (const body of bodies) {
      this.#depths[body] = this.#ways[body] = 0;
      for (let k = 0; k < 3; k++) this.#depths[body]! += down[k]! * this.#bodies.originOf(body, k);
    }
    return load > 0;
  }

  // ---- what bears what ----------------------------------------------------------------------------------------------

  /** Each that may bear goes to the upper one of its bodies. `fastest`: what lies farther apart may close faster, m/s. */
  #sortContacts(bodies: readonly number[], contacts: readonly number[], fastest: number): void {
    const { a, b, count } = this.#contacts;
    if (this.#next.length < count) {
      this.#next = grownInt(this.#next, 2 * count);
      this.#wrenches = grown(this.#wrenches, 2 * SIZE * count);
    }
    for (const body of bodies) this.#first[body] = -1;
    for (const i of contacts) {
      if (!this.#isBuiltToTouch(i, fastest)) continue;
      const bearsA = this.#bearsA(i);
      const away = bearsA ? -this.#levelOf(i) : this.#levelOf(i);
      if (away < LEVEL) continue;
      const body = bearsA ? a[i]! : b[i]!;
      this.#next[i] = this.#first[body]!;
      this.#first[body] = i;
      this.#readWrench(i, bearsA);
    }
  }

  /** And is not carried up or down by its author, nor thrown back. */
  #isBuiltToTouch(i: number, fastest: number): boolean {
    const c = this.#contacts.values;
    const target = c[i * C.size + C.target]!;
    return target <= 0 && target >= -fastest && c[i * C.size + C.driven] === 0;
  }

  #bearsA(i: number): boolean {
    const a = this.#contacts.a[i]!;
    const b = this.#contacts.b[i]!;
    return b < 0 || (a >= 0 && this.#depths[a]! <= this.#depths[b]!);
  }

  /** How far its normal points down, -1 to 1. */
  #levelOf(i: number): number {
    return dot3(this.#contacts.values, i * C.size + C.normal, this.#down, 0);
  }

  #readWrench(i: number, ofA: boolean): void {
    const c = this.#contacts.values;
    const w = this.#wrenches;
    const from = i * C.size;
    const at = i * SIZE;
    cross3(w, at + 3, c, from + (ofA ? C.armA : C.armB), c, from + C.normal);
    for (let k = 0; k < 3; k++) w[at + k] = c[from + C.normal + k]!;
    if (!ofA) for (let k = 0; k < SIZE; k++) w[at + k]! *= -1;
  }

  // ---- one body -----------------------------------------------------------------------------------------------------

  /** By the smallest pushes, in squares, that bear it without a pull. */
  #bear(body: number): void {
    while (this.#first[body]! >= 0) {
      if (!this.#findPushes(body)) return;
      if (!this.#leaveOutPulls(body)) break;
    }
    const { values: c, a, b } = this.#contacts;
    for (let i = this.#first[body]!; i >= 0; i = this.#next[i]!)
      takePush(c, i * C.size, this.#bodies.momentum, a[i]!, b[i]!, C.impulse, 1);
  }

  /** λ = Wᵀ (W Wᵀ)⁻¹ of what is asked. */
  #findPushes(body: number): boolean {
    const { momentum } = this.#bodies;
    const w = this.#wrenches;
    const x = this.#asked;
    this.#readSum(body);
    for (let k = 0; k < SIZE; k++) x[k] = momentum[body * SIZE + k]!;
    if (!factor(this.#sum, 0, SIZE)) return false;
    forward(this.#sum, 0, SIZE, x, 0);
    backward(this.#sum, 0, SIZE, x, 0);
    const c = this.#contacts.values;
    for (let i = this.#first[body]!; i >= 0; i = this.#next[i]!) {
      let push = 0;
      for (let k = 0; k < SIZE; k++) push += w[i * SIZE + k]! * x[k]!;
      c[i * C.size + C.impulse] = push;
    }
    return true;
  }

  /** W Wᵀ, and a little of what would make it regular: what turns by the radius of gyration. */
  #readSum(body: number): void {
    const { masses, inertias } = this.#bodies;
    const w = this.#wrenches;
    const sum = this.#sum.fill(0);
    let pushes = 0;
    for (let i = this.#first[body]!; i >= 0; i = this.#next[i]!, pushes++)
      for (let k = 0; k < SIZE; k++)
        for (let l = 0; l <= k; l++) sum[rowOf(k) + l]! += w[i * SIZE + k]! * w[i * SIZE + l]!;
    for (let k = 0; k < 3; k++) {
      sum[rowOf(k) + k]! += SINGULAR * pushes;
      sum[rowOf(k + 3) + k + 3]! +=
        (SINGULAR * pushes * inertias[9 * body + 4 * k]!) / masses[body]!;
    }
  }

  /** Whether there are any: these don't bear it. */
  #leaveOutPulls(body: number): boolean {
    const c = this.#contacts.values;
    const next = this.#next;
    let any = false;
    let last = -1;
    for (let i = this.#first[body]!; i >= 0; i = next[i]!) {
      if (c[i * C.size + C.impulse]! >= 0) {
        last = i;
        continue;
      }
      any = true;
      c[i * C.size + C.impulse] = 0;
      if (last < 0) this.#first[body] = next[i]!;
      else next[last] = next[i]!;
    }
    return any;
  }

  /** What bears it is to be closed, after what bears that: by as much as their mean, by what they bear. */
  #close(body: number, dt: number): void {
    const { values: c, a, b } = this.#contacts;
    let borne = 0;
    let way = 0;
    for (let i = this.#first[body]!; i >= 0; i = this.#next[i]!) {
      const at = i * C.size;
      const below = a[i] === body ? b[i]! : a[i]!;
      const gap = c[at + C.target] === 0 ? 0 : -dt * c[at + C.target]! - BEARS;
      const push = c[at + C.impulse]!;
      borne += push;
      way += push * (gap / Math.abs(this.#levelOf(i)) + (below < 0 ? 0 : this.#ways[below]!));
      c[at + C.target] = 0;
    }
    if (borne > 0) this.#ways[body] = way / borne;
  }
}
