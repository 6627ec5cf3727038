import { copy6, ROWS, SIDE } from '../../solver/joints/blocks.js';
import type { BoundedRows } from './bounded-rows.js';
import type { Component } from '../../solver/joints/forest.js';
import type { PointConstraints } from './point-constraints.js';
import type { RowSystem } from '../../solver/joints/row-system.js';

/** Radians in a step from which on pivots do not shake what hangs on them, but throw it. */
const THROWN = 1;

/**
 * What is shaken feels, in the end, the square of the shaking: that is what holds Kapitza's pendulum on its head. Steps miss
 * (ω dt)²/12 of it, where ω is the rate of the shaking. Where pins pull as if their bodies were turned back by 1/12 of what
 * the shaking alone turns them in a step, the torque differs by -dt²/12 α ∂α/∂q, and the mean of that is what was lost.
 */
export class ShakenPivots {
  readonly #system: RowSystem;
  readonly #pins: PointConstraints;
  readonly #bounded: BoundedRows;
  #momentum = new Float64Array(0);

  constructor(system: RowSystem, pins: PointConstraints, bounded: BoundedRows) {
    this.#system = system;
    this.#pins = pins;
    this.#bounded = bounded;
  }

  /** Bodies are numbered anew. */
  take(bodies: number): void {
    if (this.#momentum.length < bodies * SIDE) this.#momentum = new Float64Array(bodies * SIDE * 2);
  }

  /** Once all is filled, and before targets are set. */
  lean(component: Component, dt: number): void {
    if (!this.#areShaken(component, dt) || !this.#swings(component)) return;
    if (!this.#turnsByShaking(component, dt)) return;
    for (const pin of component.pins) this.#pins.lean(pin, -dt / 12);
  }

  /** Every pin is asked, since each notes its way. */
  #areShaken(component: Component, dt: number): boolean {
    let any = false;
    for (const pin of component.pins) any = this.#pins.setShaking(pin, dt) || any;
    return any;
  }

  /** Whether it hangs from link to link, and nothing drives, stops or drags it. */
  #swings({ joints, pins, rows, loops }: Component): boolean {
    if (loops.length > 0 || pins.length < joints.length) return false;
    return this.#system.resisting.size === 0 && !rows.some(this.#isBounded);
  }

  readonly #isBounded = (k: number): boolean => this.#bounded.any(k);

  /** Solves for the velocities that shaking alone gives in a step. False: none, or too fast. */
  #turnsByShaking(component: Component, dt: number): boolean {
    const { momentum, velocity, rowCount, targetVelocity, carriedRate } = this.#system;
    for (const k of component.rows)
      for (let i = k * ROWS; i < k * ROWS + rowCount[k]!; i++) targetVelocity[i] = carriedRate[i]!;
    const kept = this.#momentum;
    for (const i of component.bodies) {
      copy6(kept, i * SIDE, momentum, i * SIDE);
      momentum.fill(0, i * SIDE, (i + 1) * SIDE);
    }
    const solved = this.#system.solve(component);
    for (const i of component.bodies) copy6(momentum, i * SIDE, kept, i * SIDE);
    return solved && component.bodies.every((i) => this.#spin(velocity, i) * dt < THROWN);
  }

  #spin(velocity: Float64Array, body: number): number {
    const at = body * SIDE + 3;
    return Math.max(
      Math.abs(velocity[at]!),
      Math.abs(velocity[at + 1]!),
      Math.abs(velocity[at + 2]!),
    );
  }
}
