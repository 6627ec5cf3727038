import type { Simulation } from '../../dynamics/simulation.js';
import { bodyAAt, bodyBAt } from '../../engine/manifold.js';
import type { Effects } from '../effect/effects.js';
import { jointSolve } from '../joints/effects.js';
import type { Jointed } from '../joints/joint-solve.js';
import { Parts, type Part } from '../../solver/part.js';
import type { TouchingBodies } from './touching-bodies.js';

/** What is in touch in a step, and what hangs together by contacts and joints. */
export class TouchingParts {
  /** Pointers of the manifolds that have points. */
  readonly manifolds: number[] = [];
  readonly #simulation: Simulation;
  readonly #effects: Effects;
  readonly #bodies: TouchingBodies;
  readonly #parts = new Parts();
  /** Those whose bodies are joined already. */
  readonly #joined = new Set<Jointed>();

  constructor(simulation: Simulation, effects: Effects, bodies: TouchingBodies) {
    this.#simulation = simulation;
    this.#effects = effects;
    this.#bodies = bodies;
  }

  get count(): number {
    return this.#parts.count;
  }

  at(i: number): Part {
    return this.#parts.at(i);
  }

  gather(): void {
    this.manifolds.length = 0;
    this.#bodies.begin();
    this.#parts.begin();
    this.#simulation.bullet.eachAwakeTouching(this.#see);
    for (const manifold of this.manifolds) this.#join(manifold);
    this.#joinJointed();
    this.#parts.sort(this.#bodies.count);
    for (const manifold of this.manifolds) this.#sort(manifold);
  }

  readonly #see = (manifold: number): void => void this.manifolds.push(manifold);

  #join(manifold: number): void {
    const { ammo } = this.#simulation.engine;
    const a = this.#numberOf(bodyAAt(ammo, manifold));
    const b = this.#numberOf(bodyBAt(ammo, manifold));
    if (a >= 0 && b >= 0) this.#parts.join(a, b);
  }

  #sort(manifold: number): void {
    const { ammo } = this.#simulation.engine;
    const a = this.#numberOf(bodyAAt(ammo, manifold));
    const b = this.#numberOf(bodyBAt(ammo, manifold));
    this.#parts.of(a >= 0 ? a : b).manifolds.push(manifold);
  }

  #numberOf(pointer: number): number {
    const before = this.#bodies.count;
    const i = this.#bodies.numberOf(pointer);
    if (i === before) this.#parts.add(i);
    return i;
  }

  /** Who hangs on what touches belongs to it. */
  #joinJointed(): void {
    const joints = this.#effects.caused(jointSolve);
    if (!joints) return;
    this.#joined.clear();
    for (let i = 0; i < this.#bodies.count; i++) {
      const body = this.#simulation.bodyAt(this.#bodies.pointers[i]!);
      const jointed = body && body.joints.size > 0 && joints.solvedWith(body);
      if (!jointed || this.#joined.has(jointed)) continue;
      this.#joined.add(jointed);
      this.#parts.hangs(i);
      // A tree, held by the world, has as many joints as bodies.
      if (jointed.joints.length > jointed.bodies.length) this.#parts.loops(i);
      for (const { pointer } of jointed.bodies) {
        const other = this.#numberOf(pointer);
        if (other >= 0) this.#parts.join(i, other);
      }
    }
  }
}
