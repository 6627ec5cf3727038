import type { Body } from '../../dynamics/body.js';
import type { Joint } from '../../dynamics/joint.js';
import type { Simulation } from '../../dynamics/simulation.js';
import { SIDE } from '../../solver/joints/blocks.js';
import type { Component, Edge, Forest } from '../../solver/joints/forest.js';
import { ComponentSolve } from './component-solve.js';

/** How bodies and joints are numbered, until that changes. */
interface Numbering {
  bodies: Body[];
  joints: readonly Joint[];
  edges: Edge[];
  forest: Forest;
}

/**
 * Velocities of the end of a step, where joints have those of its middle: half a step of what pulls is added, and their joints
 * take from it what they hold. It is worked out for who asks, and where a load begins or ends: that acts from its instant.
 */
export class MomentVelocities {
  readonly #simulation: Simulation;
  /** Of the steps. */
  readonly #solver: ComponentSolve;
  /** Has its own rows: looking changes nothing. */
  readonly #own: ComponentSolve;
  #numbering: Numbering | undefined;
  /** Numbers of bodies; undefined until somebody asks after they were numbered. */
  #numbers: Map<Body, number> | undefined;
  /** Of each component, the step after which it was asked for last, and whether there is an answer. */
  #asked = new WeakMap<Component, { step: number; known: boolean }>();
  #velocities = new Float64Array(0);

  constructor(simulation: Simulation, solver: ComponentSolve) {
    this.#simulation = simulation;
    this.#solver = solver;
    this.#own = new ComponentSolve(simulation, solver.bodies);
  }

  /** Bodies and joints are numbered anew. The list of those who number them gets gaps where joints go; this one keeps them. */
  take(bodies: Body[], joints: readonly Joint[], edges: Edge[], forest: Forest): void {
    this.#numbering = { bodies, joints: [...joints], edges, forest };
    this.#numbers = undefined;
  }

  /** Six numbers of a body from `at` on; undefined: those that it has are those of this moment, as far as anybody knows. */
  of(component: Component, body: Body): { velocities: Float64Array; at: number } | undefined {
    if (!this.#lag(component) || !this.#isKnown(component)) return undefined;
    return { velocities: this.#velocities, at: SIDE * this.#numbers!.get(body)! };
  }

  /** From now on its bodies have the velocities of this moment. */
  settle(component: Component): void {
    if (!this.#lag(component) || !this.#isKnown(component)) return;
    const { bodies, engine } = this.#simulation;
    for (const i of component.bodies) {
      const body = this.#solver.bodies.bodies[i]!;
      engine.velocities.write(body.pointer, this.#velocities, i * SIDE);
      this.#solver.bodies.relaunch(body);
      bodies.readVelocity(body);
    }
  }

  #lag({ bodies }: Component): boolean {
    const jointed = this.#solver.bodies;
    for (const i of bodies) if (jointed.lastStep(jointed.bodies[i]!) > 0) return true;
    return false;
  }

  #isKnown(component: Component): boolean {
    const step = this.#simulation.stepsTaken;
    const asked = this.#asked.get(component);
    if (asked?.step === step && this.#numbers) return asked.known;
    if (!this.#numbers) this.#renumber();
    const known = this.#solve(component);
    this.#asked.set(component, { step, known });
    return known;
  }

  #renumber(): void {
    const { bodies, joints, edges, forest } = this.#numbering!;
    this.#own.take(bodies, joints, [], edges, forest);
    this.#numbers = new Map(bodies.map((body, i) => [body, i]));
    this.#velocities = new Float64Array(bodies.length * SIDE);
  }

  #solve(component: Component): boolean {
    if (!this.#solver.hangsFree(component)) return false;
    const found = this.#own.atMoment(component);
    if (!found) return false;
    // As Bullet would keep them.
    for (const i of component.bodies)
      for (let x = i * SIDE; x < (i + 1) * SIDE; x++) this.#velocities[x] = Math.fround(found[x]!);
    return true;
  }
}
