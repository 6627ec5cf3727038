import type { Draws } from './emit/draws.js';
import type { Settings } from './settings.js';
import { Wind } from './wind.js';

/** What pushes the particles of a system, m/s²: its forces and winds. */
export class Pushes {
  /** All of them alike, in this step, and in the one before. */
  readonly all = new Float64Array(3);
  readonly #before = new Float64Array(3);
  readonly #own = new Float64Array(3);
  winds: readonly Wind[] = [];
  /** Some winds push each particle another way. */
  whirls = false;

  /** What its author says. */
  read({ winds, mass }: Settings, draws: Draws): void {
    this.winds = winds.map((wind, n) => new Wind(wind, draws, n));
    this.whirls = mass > 0 && this.winds.some(({ whirls }) => whirls);
  }

  /** A step begins: gusts do so with one, too. */
  begin({ force, mass, surfaceArea }: Settings, gust: number): void {
    const { all } = this;
    for (let i = 0; i < 3; i++) {
      this.#before[i] = all[i]!;
      all[i] = mass > 0 ? force[i]! / mass : 0;
    }
    if (mass <= 0) return;
    for (const wind of this.winds) {
      wind.begin(gust, surfaceArea / mass);
      if (!wind.whirls) wind.addToAll(all);
    }
  }

  /** Whether each is pushed as in the step before. */
  get isAsBefore(): boolean {
    if (this.whirls) return false;
    for (let i = 0; i < 3; i++) if (this.all[i] !== this.#before[i]) return false;
    return true;
  }

  /** What pushes the `number`-th. */
  of(number: number): Float64Array {
    if (!this.whirls) return this.all;
    for (let i = 0; i < 3; i++) this.#own[i] = this.all[i]!;
    for (const wind of this.winds) if (wind.whirls) wind.addTo(number, this.#own);
    return this.#own;
  }
}
