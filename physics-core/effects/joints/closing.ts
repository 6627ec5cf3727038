/** Rounds, at most, in which joints are brought together after a step. */
const ROUNDS = 30;

/** How far rows give way at first, where rounds do not help, and at most: shares of what a row does to its bodies. */
const FIRST = 1e-5;
const MOST = 10;

/** An error that shrinks by less in a round is hardly worth it, and so many of those are the last. */
const PROGRESS = 0.9;
const TRIES = 3;

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
    if (this.#loops && !this.better) this.give = Math.max(FIRST, this.give * 30);
    else if (this.give > 0) this.give = this.give > FIRST ? this.give / 3 : 0;
    if (this.#loops && worst > PROGRESS * this.#least) this.#slow++;
    else this.#slow = 0;
    this.#least = Math.min(this.#least, worst);
    return this.#round++ < ROUNDS && this.#slow < TRIES && this.give < MOST;
  }
}
