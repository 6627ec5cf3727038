import { DEFAULT_LEVEL, levelNamed, levels, type Level } from '../../dynamics/levels.js';
import type { FollowingLevel, Verdict } from './effects.js';

/** Frames that a verdict is made of, and least seconds between two changes of level. */
const FRAMES = 60;
const INTERVAL = 1;

/** A finer level is taken where it should leave this share of the budget unused. */
const SPARE = 0.2;

/** What a finer level costs more, until it is known: twice the steps, and iterations only count in part. */
const expectedGrowth = (from: Level, to: Level): number =>
  (from.timeStep / to.timeStep) * Math.sqrt(to.iterations / from.iterations);

/** Bounds of what was seen of it: loads that come and go meanwhile are no growth. */
const GROWTH = [1.2, 6] as const;

/** The finest level whose frames fit a budget: one level at a time, so a factor of two in the step. */
export class AutoLevel implements FollowingLevel {
  level: Level = levelNamed(DEFAULT_LEVEL);
  readonly #costs = new Float64Array(FRAMES);
  readonly #sorted = new Float64Array(FRAMES);
  #frames = 0;
  #seconds = 0;
  /** How often a level costs what the one before it does, as last seen. */
  readonly #growth = levels.map((level, i) => (i ? expectedGrowth(levels[i - 1]!, level) : 1));
  /** The level before this one and its p90, until this one's is known. */
  #before: { index: number; p90: number } | undefined;

  begin(level: Level): void {
    this.level = level;
    this.#before = undefined;
    this.#forgetFrames();
  }

  #forgetFrames(): void {
    this.#frames = 0;
    this.#seconds = 0;
  }

  note(ms: number, seconds: number, budget: number): Verdict | undefined {
    this.#costs[this.#frames % FRAMES] = ms;
    this.#frames++;
    this.#seconds += seconds;
    if (this.#frames < FRAMES || this.#seconds < INTERVAL) return undefined;
    this.#sorted.set(this.#costs);
    const p90 = this.#sorted.sort()[FRAMES * 0.9 - 1]!;
    this.#learn(p90);
    const index = levels.indexOf(this.level);
    if (p90 > budget && index > 0) return this.#change(index - 1, 'over budget', p90);
    const next = this.#growth[index + 1];
    if (next !== undefined && p90 * next < budget * (1 - SPARE))
      return this.#change(index + 1, 'room for more', p90);
    return undefined;
  }

  #change(index: number, because: Verdict['because'], p90: number): Verdict {
    this.#before = { index: levels.indexOf(this.level), p90 };
    this.level = levels[index]!;
    this.#forgetFrames();
    return { level: this.level, because, p90 };
  }

  /** What the last change did to the cost. */
  #learn(p90: number): void {
    if (!this.#before) return;
    const { index, p90: before } = this.#before;
    this.#before = undefined;
    const now = levels.indexOf(this.level);
    const [coarse, fine] = now > index ? [before, p90] : [p90, before];
    if (coarse > 0)
      this.#growth[Math.max(now, index)] = Math.min(GROWTH[1], Math.max(GROWTH[0], fine / coarse));
  }
}
