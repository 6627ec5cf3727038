import { MATRIX } from '../../base/matrix.js';
import { SIDE } from '../../solver/joints/blocks.js';
import type { Component } from '../../solver/joints/forest.js';
import type { JointedBodies } from './jointed-bodies.js';
import type { RowSystem } from '../../solver/joints/row-system.js';

/** Share of the most energy of motion there was that steps may seem to gain: velocities are those of the middle of a step. */
const SLACK = 3e-3;

/** Joules. */
interface Account {
  /** Energy of motion that the bodies may have: what they had, and what forces did since. */
  budget: number;
  most: number;
  /** What the last step left them. */
  left: number;
}

/**
 * Joints do no work. In a loop or a long chain that cracks like a whip faster than steps can follow they would: what is
 * whole at the end of a step may have been thrown there. Accounts of such parts tell by how much their motion is to be slowed.
 */
export class EnergyBudget {
  readonly #system: RowSystem;
  readonly #bodies: JointedBodies;
  /** Of the momentum of this step. */
  #kept = 1;
  readonly #accounts = new Map<Component, Account>();

  constructor(system: RowSystem, bodies: JointedBodies) {
    this.#system = system;
    this.#bodies = bodies;
  }

  /** Components are others, or one of them was moved by something that does work. */
  forget(component?: Component): void {
    if (component) this.#accounts.delete(component);
    else this.#accounts.clear();
  }

  /** Three numbers; undefined: it has none. */
  keep(component: Component): Float64Array | undefined {
    const account = this.#accounts.get(component);
    return account && Float64Array.of(account.budget, account.most, account.left);
  }

  goOn(component: Component, [budget, most, left]: Float64Array): void {
    this.#accounts.set(component, { budget: budget!, most: most!, left: left! });
  }

  /** What else acted since the last step is allowed for. */
  begin(component: Component): void {
    this.#kept = 1;
    const now = this.#energy(component, this.#bodies.velocity, this.#bodies.velocity);
    const account = this.#accounts.get(component);
    if (!account) this.#accounts.set(component, { budget: now, most: now, left: now });
    else account.budget += now - account.left;
  }

  /** The share of its momentum that a component may keep: below 1 where the velocities found have too much energy. */
  share(component: Component): number {
    const { budget, most } = this.#accounts.get(component)!;
    const allowed = Math.max(0, budget + this.#work(component));
    const energy = this.#energyAfter(component);
    const slack = SLACK * Math.max(most, allowed);
    return energy > allowed + slack ? Math.sqrt((allowed + slack / 2) / energy) : 1;
  }

  /** The velocities found stand. */
  end(component: Component): void {
    const account = this.#accounts.get(component)!;
    account.budget += this.#work(component);
    account.most = Math.max(account.most, account.budget);
    account.left = this.#energyAfter(component);
  }

  /** The momentum that is to be kept of a component. */
  slow({ bodies }: Component, share: number): void {
    const { momentum } = this.#system;
    this.#kept *= share;
    for (const i of bodies) for (let x = i * SIDE; x < (i + 1) * SIDE; x++) momentum[x]! *= share;
  }

  #energyAfter(component: Component): number {
    return this.#energy(component, this.#system.velocity, this.#system.velocity);
  }

  /** Half of u M v. */
  #energy({ bodies }: Component, u: Float64Array, v: Float64Array): number {
    let sum = 0;
    for (const i of bodies) {
      const o = i * MATRIX;
      const at = i * SIDE;
      const along = u[at]! * v[at]! + u[at + 1]! * v[at + 1]! + u[at + 2]! * v[at + 2]!;
      sum += this.#bodies.mass(i) * along;
      for (let k = 0; k < 3; k++)
        sum +=
          this.#bodies.moment(i, k) *
          this.#bodies.along(u, at, o + k) *
          this.#bodies.along(v, at, o + k);
    }
    return sum / 2;
  }

  /** What forces and damping do in the step: the momentum they bring, at the mean of the velocities before and after. */
  #work(component: Component): number {
    const { momentum, velocity } = this.#system;
    const before = this.#bodies.velocity;
    let brought = 0;
    for (const i of component.bodies)
      for (let x = i * SIDE; x < (i + 1) * SIDE; x++)
        brought += momentum[x]! * (before[x]! + velocity[x]!);
    const had = this.#energy(component, before, before) + this.#energy(component, before, velocity);
    return brought / (2 * this.#kept) - had;
  }
}
