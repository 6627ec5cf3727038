/** Matrices that are saved up in a step, at most so many: 400 boxes of a wall need 40 in their first step, then one or none. */
const STEP = 0.5;
const MOST = 60;

/**
 * Matrices that large parts of a busy world may factor, in all: a structure that stands needs few once they are solved, and
 * goes on with them; a heap that settles would need many in each step, and gets a try when enough are saved up again.
 */
export class Savings {
  #saved = MOST;
  /** The steps in which something was saved last, and the last try came to its end. */
  #saving = -1;
  #solved = -1;

  forget(): void {
    this.#saved = MOST;
    this.#saving = this.#solved = -1;
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
    if (step !== this.#saving) this.#saved = Math.min(MOST, this.#saved + STEP);
    this.#saving = step;
    const goesOn = this.#solved >= step - 1;
    if (goesOn ? this.#saved < 1 : !worth || this.#saved < MOST) return false;
    const { done, used } = tryWith(Math.floor(this.#saved));
    this.#saved -= used;
    if (done) this.#solved = step;
    return done;
  }
}
