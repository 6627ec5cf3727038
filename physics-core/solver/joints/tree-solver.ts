import { backward, factor, forward, rowOf } from '../../base/cholesky.js';
import { backwardBody, factorBody, forwardBody } from './body-triangles.js';
import { add6, BODY_BLOCK, copy6, dot6, JOINT_BLOCK, ROW_BLOCK, ROWS, SIDE } from './blocks.js';
import type { Component } from './forest.js';
import type { PointSolver } from './point-solver.js';
import type { RowSystem } from './row-system.js';
import { LEAST_COMPLIANCE } from '../tolerances.js';

/**
 * Bodies are eliminated from the leaves to the root: each hands its inertia on to its parent through the joint between
 * them (the articulated-body recursion, in maximal coordinates). Linear time, nothing fills in.
 */
export class TreeSolver {
  readonly #system: RowSystem;
  readonly #pins: PointSolver;
  /** Cholesky factors of each body's inertia with its subtree's, and of each joint's rows. */
  #bodies = new Float64Array(0);
  #joints = new Float64Array(0);
  /** Velocity of the child per impulse of each row that holds, and the row as the parent sees it. */
  #response = new Float64Array(0);
  #seen = new Float64Array(0);
  /** What each row still has to do, as its child sees it. */
  #rest = new Float64Array(0);
  readonly #block = new Float64Array(ROW_BLOCK);
  readonly #rows = new Float64Array(ROWS);

  constructor(system: RowSystem, pins: PointSolver) {
    this.#system = system;
    this.#pins = pins;
  }

  growBodies(room: number): void {
    this.#bodies = new Float64Array(room * BODY_BLOCK);
  }

  growJoints(room: number): void {
    this.#joints = new Float64Array(room * JOINT_BLOCK);
    this.#response = new Float64Array(room * ROW_BLOCK);
    this.#seen = new Float64Array(room * ROW_BLOCK);
    this.#rest = new Float64Array(room * ROWS);
  }

  /** Start of the rows of a joint as one of its bodies sees them. */
  #seenBy(joint: number, body: number): number {
    return (joint * 2 + +(this.#system.edges[joint]!.a !== body)) * ROW_BLOCK;
  }

  /** False: some block is not positive definite. */
  factor({ bodies }: Component): boolean {
    const { jointOf } = this.#system.forest;
    for (const body of bodies) this.#system.writeInertia(body, this.#bodies, body * BODY_BLOCK);
    for (const body of bodies) if (!this.#factor(jointOf[body]!, body)) return false;
    return true;
  }

  #factor(joint: number, body: number): boolean {
    const parent = this.#system.forest.parentOf[body]!;
    const pin = this.#isPin(joint);
    const given = pin
      ? this.#pins.factors.factor(joint, this.#bodies, body, parent)
      : factorBody(this.#bodies, body * BODY_BLOCK);
    if (!given) return false;
    if (joint < 0 || this.#system.heldCount[joint] === 0) return true;
    if (pin) this.#respondPinned(joint, body);
    else this.#respond(joint, body);
    return this.#factorRows(joint, body, parent);
  }

  #isPin(joint: number): boolean {
    return joint >= 0 && this.#system.isPin[joint] === 1;
  }

  /** How the child answers to the rows, and what they do to each other. */
  #respond(joint: number, body: number): void {
    const { jacobian, held, heldCount } = this.#system;
    const w = this.#response;
    const rows = joint * ROW_BLOCK;
    const child = this.#seenBy(joint, body);
    const n = heldCount[joint]!;
    for (let r = 0; r < n; r++) {
      const row = rows + r * SIDE;
      copy6(w, row, jacobian, child + held[joint * ROWS + r]! * SIDE);
      forwardBody(this.#bodies, body * BODY_BLOCK, w, row);
      const into = joint * JOINT_BLOCK + rowOf(r);
      for (let c = 0; c <= r; c++) this.#joints[into + c] = dot6(w, row, w, rows + c * SIDE);
    }
    for (let r = 0; r < n; r++) backwardBody(this.#bodies, body * BODY_BLOCK, w, rows + r * SIDE);
  }

  /** The same of rows about axes at a pin, which hold on to the parent through it. */
  #respondPinned(joint: number, body: number): void {
    const { jacobian, held, heldCount } = this.#system;
    const w = this.#response;
    const rows = joint * ROW_BLOCK;
    const child = this.#seenBy(joint, body);
    for (let r = 0; r < heldCount[joint]!; r++) {
      const from = child + held[joint * ROWS + r]! * SIDE;
      const row = rows + r * SIDE;
      this.#pins.respond(joint, jacobian, from, w, row);
      this.#pins.see(joint, jacobian, from, this.#seen, row);
      const into = joint * JOINT_BLOCK + rowOf(r);
      for (let c = 0; c <= r; c++)
        this.#joints[into + c] = dot6(jacobian, from, w, rows + c * SIDE);
    }
  }

  #factorRows(joint: number, body: number, parent: number): boolean {
    const { compliance, held, heldCount } = this.#system;
    const n = heldCount[joint]!;
    const at = joint * JOINT_BLOCK;
    const first = joint * ROWS;
    const k = this.#joints;
    for (let r = 0; r < n; r++) {
      const i = at + rowOf(r) + r;
      k[i] = k[i]! * (1 + LEAST_COMPLIANCE) + compliance[first + held[first + r]!]!;
    }
    if (!factor(k, at, n)) return false;
    if (parent < 0) return true;
    if (!this.#isPin(joint)) this.#copySeen(joint, parent);
    this.#loadParent(joint, parent, n);
    return true;
  }

  #copySeen(joint: number, parent: number): void {
    const { jacobian, held, heldCount } = this.#system;
    const from = this.#seenBy(joint, parent);
    for (let r = 0; r < heldCount[joint]!; r++)
      copy6(
        this.#seen,
        joint * ROW_BLOCK + r * SIDE,
        jacobian,
        from + held[joint * ROWS + r]! * SIDE,
      );
  }

  /** Inertia of the parent += Jᵀ K⁻¹ J. */
  #loadParent(joint: number, parent: number, n: number): void {
    const k = this.#joints;
    const at = joint * JOINT_BLOCK;
    const y = this.#block;
    const inertia = parent * BODY_BLOCK;
    for (let r = 0; r < n; r++) {
      const o = r * SIDE;
      const row = at + rowOf(r);
      copy6(y, o, this.#seen, joint * ROW_BLOCK + o);
      for (let c = 0; c < r; c++) add6(y, o, y, c * SIDE, -k[row + c]!);
      for (let x = 0; x < SIDE; x++) y[o + x]! *= k[row + r]!;
      for (let i = 0; i < SIDE; i++) {
        const scale = y[o + i]!;
        const into = inertia + rowOf(i);
        for (let j = 0; j <= i; j++) this.#bodies[into + j]! += scale * y[o + j]!;
      }
    }
  }

  /** Velocities and impulses under the momenta of `load`, which are used up. */
  solve({ bodies }: Component, load: Float64Array): void {
    const { jointOf } = this.#system.forest;
    for (const body of bodies) {
      const joint = jointOf[body]!;
      if (joint >= 0) this.#gather(joint, body, load);
    }
    for (let i = bodies.length - 1; i >= 0; i--)
      this.#release(jointOf[bodies[i]!]!, bodies[i]!, load);
  }

  /** From the leaves: what the joint has to do, handed on to the parent. */
  #gather(joint: number, body: number, load: Float64Array): void {
    const { heldCount, forest } = this.#system;
    const parent = forest.parentOf[body]!;
    const pin = this.#isPin(joint);
    if (pin) this.#pins.gather(joint, load, body, parent);
    if (heldCount[joint]! > 0) this.#gatherRows(joint, body, parent, load, pin);
  }

  #gatherRows(joint: number, body: number, parent: number, load: Float64Array, pin: boolean): void {
    const { targetVelocity, carriedRate, held, heldCount } = this.#system;
    const n = heldCount[joint]!;
    const at = joint * JOINT_BLOCK;
    const s = this.#rows;
    for (let r = 0; r < n; r++) {
      const i = joint * ROWS + r;
      const row = joint * ROW_BLOCK + r * SIDE;
      const at0 = joint * ROWS + held[i]!;
      let wants = targetVelocity[at0]! - carriedRate[at0]!;
      if (pin) wants -= this.#pins.wants(joint, this.#seen, row);
      s[r] = this.#rest[i] = wants - dot6(this.#response, row, load, body * SIDE);
    }
    if (parent < 0) return;
    forward(this.#joints, at, n, s, 0);
    backward(this.#joints, at, n, s, 0);
    for (let r = 0; r < n; r++)
      add6(load, parent * SIDE, this.#seen, joint * ROW_BLOCK + r * SIDE, s[r]!);
  }

  /** From the root: the parent's velocity is known, then the joint's impulses, then the child's velocity. */
  #release(joint: number, body: number, load: Float64Array): void {
    const { velocity, heldCount, forest } = this.#system;
    const parent = forest.parentOf[body]!;
    const pin = this.#isPin(joint);
    if (pin) this.#pins.release(joint, velocity, body, parent);
    else {
      const v = body * SIDE;
      copy6(velocity, v, load, v);
      forwardBody(this.#bodies, body * BODY_BLOCK, velocity, v);
      backwardBody(this.#bodies, body * BODY_BLOCK, velocity, v);
    }
    if (joint >= 0 && heldCount[joint]! > 0) this.#releaseRows(joint, body, parent, pin);
  }

  #releaseRows(joint: number, body: number, parent: number, pin: boolean): void {
    const { velocity, impulse, held, heldCount } = this.#system;
    const n = heldCount[joint]!;
    const at = joint * JOINT_BLOCK;
    const rows = joint * ROW_BLOCK;
    const s = this.#rows;
    for (let r = 0; r < n; r++) {
      s[r] = this.#rest[joint * ROWS + r]!;
      if (parent >= 0) s[r]! -= dot6(this.#seen, rows + r * SIDE, velocity, parent * SIDE);
    }
    forward(this.#joints, at, n, s, 0);
    backward(this.#joints, at, n, s, 0);
    for (let r = 0; r < n; r++) {
      impulse[joint * ROWS + held[joint * ROWS + r]!] = s[r]!;
      add6(velocity, body * SIDE, this.#response, rows + r * SIDE, s[r]!);
      if (pin) this.#pins.note(joint, this.#seen, rows + r * SIDE, s[r]!);
    }
  }
}
