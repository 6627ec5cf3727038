import { mix, type Pose } from '../../base/math.js';
import type { MovingNode } from '../../nodes/body-motion.js';
import type { World } from '../../world/world.js';
import { Effect } from '../effect.js';

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
  readonly name = 'carrying';
  readonly #world: World;
  readonly #moves = new Map<MovingNode, Move>();

  constructor(world: World) {
    super();
    this.#world = world;
  }

  carried(body: MovingNode, from: Pose, to: Pose): void {
    const since = this.#world.time;
    const last = this.#moves.get(body);
    // Position and orientation come one after the other: together they are one move.
    if (last && last.since === since) last.to = to;
    else this.#moves.set(body, { from, to, since, duration: last ? since - last.since : FRAME });
    this.need(body, 'position');
  }

  override drop(body: MovingNode): void {
    super.drop(body);
    this.#moves.delete(body);
  }

  /** Bullet takes the velocity of a kinematic body from how far its pose is from the interpolation pose. */
  override beforeStep(dt: number): void {
    const { scratch } = this.#world.engine;
    for (const [body, { from, to, since, duration }] of this.#moves) {
      if (this.#world.time - since >= duration - dt / 2) continue;
      const { p, q } = mix(to, from, Math.min(1, dt / duration));
      body.body.setInterpolationWorldTransform(scratch.transform(p, q));
    }
  }

  override afterStep(): void {
    for (const [body, { since }] of this.#moves) {
      if (this.#world.time - since < STILL) continue;
      this.drop(body);
      body.standStill();
    }
  }
}
