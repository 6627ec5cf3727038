import {
  CLOSING_PROGRESS,
  CLOSING_ROUNDS,
  CLOSING_TRIES,
  FIRST_GIVE,
  LEAST_GIVE,
  MOST_GIVE,
} from '../tolerances.js';

/**
 * The rounds of bringing together what a step left open. Loops that are taut can't be made whole: the straight way to where
 * they would be leads far off. Rows then give way, the more the less it helps, until what is left is spread over all of
 * them (Levenberg and Marquardt's way).
 */
export class Closing {
  /** Without loops each round helps, if not at once: none is undone. */
  #loops = false;
  #round = 0;
  #slow = 0;
  #least = Infinity;
  #last = 0;
  give = 0;
  /** Whether the last round helped; what did not is undone. */
  better = true;

  begin(loops: boolean): void {
    this.#loops = loops;
    this.#round = this.#slow = 0;
    this.#least = Infinity;
    this.give = 0;
    this.better = true;
  }

  /** What the rounds left open. */
  get left(): number {
    return this.#loops ? this.#least : this.#last;
  }

  /** Whether there is to be another round, with errors as they are now. */
  goesOn(worst: number, least: number): boolean {
    this.#last = worst;
    this.better = !this.#loops || worst <= this.#least;
    if (worst < least) {
      this.#least = worst;
      return false;
    }
    if (this.#loops && !this.better) this.give = Math.max(FIRST_GIVE, this.give * 30);
    else if (this.give > 0) this.give = this.give > LEAST_GIVE ? this.give / 3 : 0;
    // A round that is undone and tried again with more give says nothing about what is left to gain.
    if (worst <= CLOSING_PROGRESS * this.#least) this.#slow = 0;
    else if (this.#loops && this.better) this.#slow++;
    this.#least = Math.min(this.#least, worst);
    return this.#round++ < CLOSING_ROUNDS && this.#slow < CLOSING_TRIES && this.give < MOST_GIVE;
  }
}
