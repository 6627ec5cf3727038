import { guards } from '../../base/guards.js';
import { dot, subtract } from '../../base/math.js';
import type { Body } from '../../dynamics/body.js';
import { isJointed } from '../../dynamics/jointed.js';
import { levelNames, type LevelName } from '../../dynamics/levels.js';
import { keyOf } from '../../effects/contacts/touches.js';
import type { PiledWorld } from '../../effects/effect/chunks.js';
import { Streaks } from './streaks.js';

/**
 * A body on one so many times lighter is more than contacts hold. Measured: five boxes of 1 kg under as many kg stay within
 * 0.11, 0.25, 0.45, 0.18 and 0.09 mm of their places; under 10,000 kg they leave them by 5.9 mm at game and 1.5 at standard.
 */
export const MOST_MASS_RATIO: Readonly<Record<LevelName, number>> = {
  game: 1000,
  standard: 3000,
  fine: 10_000,
  precise: 10_000,
  reference: 10_000,
};

/** Looks in a row that must find the same: what hits is thrown out at once. */
const LOOKS = 2;

/** Bodies that hang together by contacts: the heaviest shall lie on none that is far lighter. */
export class UnlikeMasses {
  readonly #world: PiledWorld;
  readonly #streaks = new Streaks();
  /** Heavy bodies that were told of, and the light ones below them. */
  readonly #told = new Map<Body, Body>();

  constructor(world: PiledWorld) {
    this.#world = world;
  }

  forget(): void {
    this.#streaks.forget();
  }

  /** The greatest mass and the smallest one of all. */
  look(most: number, least: number): void {
    this.#streaks.begin();
    this.#settle();
    if (most > this.#limit * least) this.#lookAtPiles();
  }

  /** Masses are others, the level is finer, or one of them is gone. */
  #settle(): void {
    for (const [heavy, light] of this.#told) {
      if (heavy.active && light.active && this.#isUnlike(heavy, light)) continue;
      this.#told.delete(heavy);
      this.#world.settle(heavy, undefined, 'mass-ratio');
    }
  }

  #isUnlike(heavy: Body, light: Body): boolean {
    return !guards.alike(heavy.mass.mass, light.mass.mass, this.#limit);
  }

  get #limit(): number {
    return MOST_MASS_RATIO[this.#world.accuracy];
  }

  #lookAtPiles(): void {
    const { bodies, engine } = this.#world;
    const piles = new Map<number, { heavy: Body; light: Body }>();
    for (const body of bodies) {
      // What hangs on joints is told of by them.
      if (!body.movable || isJointed(body)) continue;
      const island = engine.reader.island(body.pointer);
      if (island < 0) continue;
      const pile = piles.get(island);
      if (!pile) piles.set(island, { heavy: body, light: body });
      else if (body.mass.mass > pile.heavy.mass.mass) pile.heavy = body;
      else if (body.mass.mass < pile.light.mass.mass) pile.light = body;
    }
    for (const { heavy, light } of piles.values())
      if (this.#weighsOn(heavy, light)) this.#note(heavy, light);
  }

  /** Whether a body is higher than one that is far lighter: the other way round all is well. */
  #weighsOn(heavy: Body, light: Body): boolean {
    const down = subtract(light.pose().p, heavy.pose().p);
    return this.#isUnlike(heavy, light) && dot(heavy.gravity, down) > 0;
  }

  #note(heavy: Body, light: Body): void {
    if (this.#streaks.note(keyOf(heavy, light)) < LOOKS) return;
    this.#told.set(heavy, light);
    const ratio = heavy.mass.mass / light.mass.mass;
    this.#world.report(
      {
        code: 'mass-ratio',
        severity: 'warning',
        value: ratio,
        used: 'the present accuracy',
        message: `${heavy.label} (${show(heavy.mass.mass)} kg) weighs on ${light.label} (${show(light.mass.mass)} kg): ${this.#promise(ratio)}`,
      },
      heavy,
    );
  }

  /** What is held, and from which level on this would be. */
  #promise(ratio: number): string {
    const better = levelNames.find((name) => MOST_MASS_RATIO[name] >= ratio);
    const most = Math.max(...Object.values(MOST_MASS_RATIO));
    return better
      ? `at accuracy="${this.#world.accuracy}" contacts hold no more than ${this.#limit} times what lies below; accuracy="${better}" or better holds this`
      : `contacts hold no more than ${most} times what lies below`;
  }
}

const show = (value: number): string => String(Number(value.toPrecision(3)));
