import { compose } from '../../base/math.js';
import type { Body } from '../../dynamics/body.js';
import type { Vec3 } from '../../fields/types.js';
import type { Cause } from '../effect/effect.js';
import type { Deformable } from './deformable.js';
import type { Guests } from './guests.js';
import type { DeformableSource } from './settings.js';
import { CARRIED } from './tolerances.js';

/** A node that ties a point of a cloth or a soft body to a body, or to a place in the world. */
export interface DeformableTie extends Cause {
  readonly id: number;
  readonly soft: DeformableSource | undefined;
  readonly index: number;
  /** Undefined: the world. */
  readonly body: Body | undefined;
  /** In the frame of the body, or of the world. */
  readonly position: Vec3;
  /** Its body, where it names one, stands in the world. */
  readonly holds: boolean;
}

const way = new Float64Array(6);
const off = new Float64Array(3);
const push = new Float64Array(3);
const axis = new Float64Array(3);

/** One of them in a step. */
export class Tied {
  readonly tie: DeformableTie;
  readonly deformable: Deformable;
  /** Where its point is to be when the step begins. */
  readonly #at = new Float64Array(3);
  /** How far from its point that is, metres; whether nothing carries a point as far in a step. */
  readonly jump = new Float64Array(3);
  jumps = false;

  constructor(tie: DeformableTie, deformable: Deformable) {
    this.tie = tie;
    this.deformable = deformable;
  }

  get slot(): number {
    return this.tie.body?.slot ?? -1;
  }

  begin(guests: Guests, dt: number): void {
    const { body, position, index } = this.tie;
    const at = body ? compose(body.pose(), { p: position, q: [0, 0, 0, 1] }).p : position;
    this.#at.set(at);
    if (body) guests.add(body.slot, dt);
    if (body) this.deformable.within.set(index, body.slot);
    let far = 0;
    for (let k = 0; k < 3; k++) {
      this.jump[k] = this.#at[k]! - this.deformable.places[3 * index + k]!;
      far += this.jump[k]! ** 2;
    }
    this.jumps = far > (CARRIED * dt) ** 2;
  }

  /** Its point is there, and stays. Inside of a lattice no point is the surface's. */
  pin(): void {
    this.jumps = false;
    const { masses, surface } = this.deformable.material;
    if (surface.width > 1) return;
    const carrier = surface.carriers[this.tie.index]!;
    masses.places.set(this.#at, 3 * carrier);
    masses.inverse[carrier] = 0;
  }

  /** The point and its body are taken to one place, each by how much it gives way. */
  hold(guests: Guests, time: number): void {
    const { masses, surface } = this.deformable.material;
    const { width, carriers, shares } = surface;
    const first = width * this.tie.index;
    const { slot } = this;
    way.fill(0);
    if (slot >= 0) guests.wayOf(slot, this.#at, 0, way);
    let gives = 0;
    for (let k = 0; k < 3; k++) off[k] = this.#at[k]! + way[k]!;
    for (let n = first; n < first + width; n++) {
      gives += shares[n]! ** 2 * masses.inverse[carriers[n]!]!;
      for (let k = 0; k < 3; k++) off[k]! -= shares[n]! * masses.places[3 * carriers[n]! + k]!;
    }
    const far = Math.sqrt(off[0]! ** 2 + off[1]! ** 2 + off[2]! ** 2);
    if (!(far > 0)) return;
    for (let k = 0; k < 3; k++) axis[k] = off[k]! / far;
    const all = gives + (slot >= 0 ? guests.gives(slot, this.#at, 0, axis) : 0);
    if (!(all > 0)) return;
    for (let k = 0; k < 3; k++) push[k] = off[k]! / all;
    for (let n = first; n < first + width; n++) {
      const share = shares[n]! * masses.inverse[carriers[n]!]!;
      for (let k = 0; k < 3; k++) masses.places[3 * carriers[n]! + k]! += share * push[k]!;
    }
    if (slot < 0) return;
    for (let k = 0; k < 3; k++) push[k] = -push[k]!;
    guests.push(slot, this.#at, 0, push, time);
  }
}
