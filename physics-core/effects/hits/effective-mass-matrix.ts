import type { Ammo } from '../../engine/ammo.js';
import { addVelocity, writeInverseMass } from '../../engine/body-heap.js';
import type { Body } from '../../dynamics/body.js';
import type { JointRows } from '../joints/joint-rows.js';
import { holds } from '../../dynamics/jointed.js';
import { otherEnd } from '../../dynamics/other-end.js';

/** Linear, then angular. */
const WIDTH = 6;

/** A joint's row that moves less than this share of what it would alone is held by other rows already. */
const HELD = 1e-6;

/** What an impulse does to a body at once: W = M⁻¹, less what the joints that hold it to immovable things take away. */
export class EffectiveMassMatrix {
  readonly #ammo: Ammo;
  readonly #rows: () => JointRows;
  body!: Body;
  readonly #w = new Float64Array(WIDTH * WIDTH);
  readonly #push = new Float64Array(WIDTH);
  /** Of the velocity, by the push that `inverseEffectiveMass` was last asked about. */
  readonly change = new Float64Array(WIDTH);

  constructor(ammo: Ammo, rows: () => JointRows) {
    this.#ammo = ammo;
    this.#rows = rows;
  }

  read(body: Body): void {
    this.body = body;
    if (!body.movable) {
      this.#w.fill(0);
      return;
    }
    writeInverseMass(this.#ammo, body.pointer, this.#w);
    for (const joint of body.joints) {
      if (!holds(joint) || otherEnd(joint, body)?.movable) continue;
      const first = joint.body1 === body;
      const rows = this.#rows();
      rows.fill(joint, 0);
      for (const row of joint.lockedRows)
        this.#hold(rows.jacobian, row * 2 * WIDTH + (first ? 0 : WIDTH), rows.between(row, row));
    }
  }

  /** W ← W - W jᵀ j W / (j W jᵀ): the row j of a joint gives way no more. */
  #hold(jacobian: Float64Array, at: number, free: number): void {
    for (let i = 0; i < WIDTH; i++) this.#push[i] = jacobian[at + i]!;
    const inverseEffectiveMass = this.#respond();
    if (inverseEffectiveMass <= HELD * free) return;
    for (let i = 0; i < WIDTH; i++)
      for (let j = 0; j < WIDTH; j++)
        this.#w[i * WIDTH + j]! -= (this.change[i]! * this.change[j]!) / inverseEffectiveMass;
  }

  /** What the push changes; returns its own part of that. */
  #respond(): number {
    let inverseEffectiveMass = 0;
    for (let i = 0; i < WIDTH; i++) {
      let sum = 0;
      for (let j = 0; j < WIDTH; j++) sum += this.#w[i * WIDTH + j]! * this.#push[j]!;
      this.change[i] = sum;
      inverseEffectiveMass += sum * this.#push[i]!;
    }
    return inverseEffectiveMass;
  }

  /** Change of speed along (x, y, z) at an arm from the centre of mass for an impulse of 1 N s there, 1/kg. */
  inverseEffectiveMass(arm: Float64Array, x: number, y: number, z: number): number {
    const rx = arm[0]!;
    const ry = arm[1]!;
    const rz = arm[2]!;
    const push = this.#push;
    push[0] = x;
    push[1] = y;
    push[2] = z;
    push[3] = ry * z - rz * y;
    push[4] = rz * x - rx * z;
    push[5] = rx * y - ry * x;
    return this.#respond();
  }

  /** Applies so many N s of the push that `inverseEffectiveMass` was last asked about. */
  push(impulse: number): void {
    addVelocity(this.#ammo, this.body.pointer, this.change, impulse);
  }
}
