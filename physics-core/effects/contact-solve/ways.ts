import type { Simulation } from '../../dynamics/simulation.js';
import { bodyAAt, bodyBAt, pointCountAt } from '../../engine/manifold.js';
import { speedSquared, swiftnessSquared } from '../../engine/solver-body.js';
import type { Part } from '../../solver/part.js';
import type { TouchingBodies } from './touching-bodies.js';
import type { TouchingParts } from './touching-parts.js';
import {
  BUSY,
  CALM,
  COARSE,
  FALL,
  FAST_SHARE,
  FEW,
  LARGE,
  MOST_BODIES,
  SLOW,
  SWAYING,
  TOUCHING_SHARE,
  TUMBLING,
  WORTH,
} from '../../solver/tolerances.js';

/** How a part is solved, by a matrix as long as one is to be had in `either`; what none suits has Bullet's iterations. */
export type Way = 'matrix' | 'sweeps' | 'either';

/** Which parts of a step are solved directly, and how. */
export class Ways {
  readonly parts: Part[] = [];
  /** Of each of them. */
  readonly ways: Way[] = [];
  readonly #simulation: Simulation;
  readonly #bodies: TouchingBodies;
  readonly #touching = new Set<number>();
  /** What moves has more blocks than the step has effort. */
  #tooDear = false;

  constructor(simulation: Simulation, bodies: TouchingBodies) {
    this.#simulation = simulation;
    this.#bodies = bodies;
  }

  /** False: too few of what a busy world has to be worth it. */
  choose(all: TouchingParts): boolean {
    this.parts.length = this.ways.length = 0;
    const busy = all.manifolds.length > BUSY;
    const tumbling = busy && this.#restlessOf(all) > TUMBLING;
    this.#tooDear = this.#isTooDear(all);
    let direct = 0;
    for (let i = 0; i < all.count; i++) {
      const part = all.at(i);
      const way = part.manifolds.length > 0 ? this.#wayOf(part, busy, tumbling) : undefined;
      part.direct = way !== undefined;
      if (!way) continue;
      this.parts.push(part);
      this.ways.push(way);
      direct += part.bodies.length;
    }
    return !busy || direct > WORTH * this.#bodies.count;
  }

  /** All that moves together: a share of it would be solved otherwise than the rest, and another share in each step. */
  #isTooDear(all: TouchingParts): boolean {
    let { effort } = this.#simulation.bullet.settings;
    if (effort === Infinity) return false;
    for (let i = 0; i < all.count && effort >= 0; i++)
      if (this.#moves(all.at(i))) effort -= this.#movingBlocksOf(all.at(i));
    return effort < 0;
  }

  /** Iterations would turn a car aside that rolls straight on, and let what lies on a net fall through it. */
  #moves(part: Part): boolean {
    const { bodies, manifolds, hangs, looped } = part;
    if (manifolds.length === 0 || looped) return false;
    if (hangs && this.#blocksOf(part) <= this.#simulation.bullet.settings.effort) return false;
    return this.#fasterOf(bodies, FALL, swiftnessSquared) > 0;
  }

  /** Of what moves in it, on the diagonal of its matrix: bodies, and points in touch of which one moves. */
  #movingBlocksOf({ bodies, manifolds }: Part): number {
    const { ammo } = this.#simulation.engine;
    let blocks = this.#fasterOf(bodies, FALL, swiftnessSquared);
    for (const manifold of manifolds)
      if (this.#isMoving(bodyAAt(ammo, manifold)) || this.#isMoving(bodyBAt(ammo, manifold)))
        blocks += pointCountAt(ammo, manifold);
    return blocks;
  }

  #isMoving(pointer: number): boolean {
    return swiftnessSquared(this.#simulation.engine.ammo, pointer) > FALL ** 2;
  }

  /** Of its matrix, on the diagonal: bodies, and points in touch. */
  #blocksOf({ bodies, manifolds }: Part): number {
    const { ammo } = this.#simulation.engine;
    let blocks = bodies.length;
    for (const manifold of manifolds) blocks += pointCountAt(ammo, manifold);
    return blocks;
  }

  /**
   * A matrix where that is cheaper than the iterations that it saves, and where these would let joints pull bodies through
   * what they lie on: nets, and what mostly hangs; sweeps where it is not, but most bodies are so slow
   * that contacts last from step to step.
   */
  #wayOf(part: Part, busy: boolean, tumbling: boolean): Way | undefined {
    const { bodies } = part;
    if (this.#tooDear && this.#moves(part)) return undefined;
    if (bodies.length <= FEW)
      return tumbling && this.#fasterOf(bodies, CALM) > 0 ? undefined : 'matrix';
    if (bodies.length > MOST_BODIES) return undefined;
    if (this.#simulation.timeStep < COARSE && (part.looped || this.#fewTouch(part)))
      return 'matrix';
    // A busy world saves its matrices up.
    const fast = this.#fasterOf(bodies, SLOW, busy ? speedSquared : swiftnessSquared);
    if (fast === 0) return busy && bodies.length > LARGE ? 'either' : 'matrix';
    return fast < FAST_SHARE * bodies.length ? 'sweeps' : undefined;
  }

  /** Whether most of its bodies only hang on others. */
  #fewTouch({ bodies, manifolds }: Part): boolean {
    const { ammo } = this.#simulation.engine;
    const most = TOUCHING_SHARE * bodies.length;
    this.#touching.clear();
    for (const manifold of manifolds) {
      this.#touch(bodyAAt(ammo, manifold));
      this.#touch(bodyBAt(ammo, manifold));
      if (this.#touching.size > most) return false;
    }
    return true;
  }

  #touch(pointer: number): void {
    const body = this.#bodies.numberOf(pointer);
    if (body >= 0) this.#touching.add(body);
  }

  sways({ bodies }: Part): boolean {
    return this.#fasterOf(bodies, SWAYING.speed) > SWAYING.share * bodies.length;
  }

  /** Bodies of small parts that are not calm. */
  #restlessOf(all: TouchingParts): number {
    let restless = 0;
    for (let i = 0; i < all.count; i++) {
      const { bodies } = all.at(i);
      if (bodies.length <= FEW && this.#fasterOf(bodies, CALM) > 0) restless += bodies.length;
    }
    return restless;
  }

  /** How many of them are faster than this, m/s. */
  #fasterOf(bodies: readonly number[], speed: number, squareOf = speedSquared): number {
    const { ammo } = this.#simulation.engine;
    let faster = 0;
    for (const body of bodies)
      if (squareOf(ammo, this.#bodies.pointers[body]!) > speed ** 2) faster++;
    return faster;
  }
}
