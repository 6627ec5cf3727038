import { ContactPoint } from '../../engine/contact-point.js';
import { APART } from '../../engine/manifold-points.js';
import type { Body } from '../../dynamics/body.js';
import type { Simulation } from '../../dynamics/simulation.js';
import { partAt, partsAt } from './contact-part.js';
import { Effect, type Cause } from '../effect/effect.js';

/** Two bodies, and which of their parts meet, by the number of both. */
interface Neighbours {
  a: Body;
  b: Body;
  byParts: Map<number, boolean>;
}

/**
 * Takes contacts back whose collidables do not collide, where Bullet's 15 group bits can't keep their bodies apart: a
 * point so far away is no contact for the solver.
 */
export class PairFilter extends Effect {
  readonly #simulation: Simulation;
  #contactPoint: ContactPoint | undefined;
  /** By pointer of the first body, then of the second. */
  readonly #known = new Map<number, Map<number, Neighbours>>();

  constructor(simulation: Simulation) {
    super();
    this.#simulation = simulation;
  }

  /** Who meets whom is to be asked again: membership or parts are others. */
  forget(): void {
    this.#known.clear();
  }

  override need(node: Cause, reason: string): void {
    super.need(node, reason);
    this.forget();
  }

  override release(node: Cause): void {
    super.release(node);
    this.forget();
  }

  override contact(pointer: number, a: number, b: number): boolean {
    const point = this.#point.at(pointer, a, b);
    if (this.#meet(point, a, b)) return true;
    point.solverDistance = APART;
    return false;
  }

  get #point(): ContactPoint {
    return (this.#contactPoint ??= new ContactPoint(this.#simulation.engine.ammo));
  }

  #meet(point: ContactPoint, pointerA: number, pointerB: number): boolean {
    const neighbours = this.#neighbours(pointerA, pointerB);
    if (!neighbours) return true;
    const { a, b, byParts } = neighbours;
    const parts = partsAt(point, a, b);
    let meet = byParts.get(parts);
    if (meet === undefined) byParts.set(parts, (meet = this.#ask(neighbours, point)));
    return meet;
  }

  #neighbours(pointerA: number, pointerB: number): Neighbours | undefined {
    let byB = this.#known.get(pointerA);
    if (!byB) this.#known.set(pointerA, (byB = new Map()));
    let found = byB.get(pointerB);
    if (found) return found;
    const a = this.#simulation.bodyAt(pointerA);
    const b = this.#simulation.bodyAt(pointerB);
    if (!a || !b) return undefined;
    byB.set(pointerB, (found = { a, b, byParts: new Map() }));
    return found;
  }

  #ask({ a, b }: Neighbours, point: ContactPoint): boolean {
    const first = partAt(point, a, 0);
    const second = partAt(point, b, 1);
    return !first || !second || this.#simulation.pairs.meet(a, first, b, second);
  }
}
