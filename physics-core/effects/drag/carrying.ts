import { mix, type Pose } from '../../base/math.js';
import type { Body } from '../../dynamics/body.js';
import type { Simulation } from '../../dynamics/simulation.js';
import { Effect, type Cause, type EffectDescriptor } from '../effect/effect.js';

/** Seconds without a new pose after which a carried body stands still. */
const STILL = 0.1;

/** Seconds that the first move of a carried body stands for: one frame of an animation. */
const FRAME = 1 / 60;

interface Move {
  /** Poses of the centre of mass: where it came from and where it is now. */
  from: Pose;
  to: Pose;
  /** When it was moved, and the seconds it is taken to have moved for. */
  since: number;
  duration: number;
}

/**
 * Fixed bodies that are moved along (a ROUTE, an animated Transform above): kinematic for Bullet while they move, so
 * that they push and drag what they touch. They are at their new pose at once, but their speed is that of the whole
 * move, not of one step: an animation moves them once per frame, which is several steps. At rest they are static
 * again, since nothing may sleep on a kinematic body.
 */
export class Carrying extends Effect {
  readonly #simulation: Simulation;
  readonly #moves = new Map<Body, Move>();

  constructor(simulation: Simulation) {
    super();
    this.#simulation = simulation;
  }

  carry(body: Body, from: Pose, to: Pose): void {
    const since = this.#simulation.time;
    const last = this.#moves.get(body);
    // Position and orientation come one after the other: together they are one move.
    if (last && last.since === since) last.to = to;
    else this.#moves.set(body, { from, to, since, duration: last ? since - last.since : FRAME });
    this.need(body, 'position');
  }

  override release(node: Cause): void {
    super.release(node);
    this.#moves.delete(node as Body);
  }

  /** Bullet takes the velocity of a kinematic body from how far its pose is from the interpolation pose. */
  override beforeStep(dt: number): void {
    const { scratch } = this.#simulation.engine;
    for (const [body, { from, to, since, duration }] of this.#moves) {
      if (this.#simulation.time - since >= duration - dt / 2) continue;
      const { p, q } = mix(to, from, Math.min(1, dt / duration));
      body.body.setInterpolationWorldTransform(scratch.transform(p, q));
    }
  }

  override afterStep(): void {
    for (const [body, { since }] of this.#moves) {
      if (this.#simulation.time - since < STILL) continue;
      this.release(body);
      body.standStill();
    }
  }
}

export const carrying: EffectDescriptor<Carrying> = {
  name: 'carrying',
  causes: 'a fixed body that a ROUTE, a Transform above it or a hand moves along',
  load: (simulation) => new Carrying(simulation),
};
