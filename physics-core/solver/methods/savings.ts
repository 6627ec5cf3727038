import { MATRICES_PER_STEP, MOST_SAVED } from '../tolerances.js';

/**
 * Matrices that large parts of a busy world may factor, in all: a structure that stands needs few once they are solved, and
 * goes on with them; a heap that settles would need many in each step, and gets a try when enough are saved up again.
 */
export class Savings {
  #saved = MOST_SAVED;
  /** The steps in which something was saved last, and the last try came to its end. */
  #saving = -1;
  #solved = -1;

  forget(): void {
    this.#saved = MOST_SAVED;
    this.#saving = this.#solved = -1;
  }

  /** How much is saved up, and both steps. */
  save(): [saved: number, saving: number, solved: number] {
    return [this.#saved, this.#saving, this.#solved];
  }

  load(kept: readonly [saved: number, saving: number, solved: number]): void {
    [this.#saved, this.#saving, this.#solved] = kept;
  }

  /**
   * Goes on with what there is, or begins where that is `worth` it and enough is there. False: not tried, or it came to no
   * end.
   */
  spend(
    step: number,
    worth: boolean,
    tryWith: (most: number) => { done: boolean; used: number },
  ): boolean {
    if (step !== this.#saving) this.#saved = Math.min(MOST_SAVED, this.#saved + MATRICES_PER_STEP);
    this.#saving = step;
    const goesOn = this.#solved >= step - 1;
    if (goesOn ? this.#saved < 1 : !worth || this.#saved < MOST_SAVED) return false;
    const { done, used } = tryWith(Math.floor(this.#saved));
    this.#saved -= used;
    if (done) this.#solved = step;
    return done;
  }
}
