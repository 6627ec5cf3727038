/** Longest stretch of wall time one frame may stand for, seconds: longer is a hidden tab, not a slow frame. */
const LONGEST = 1;
/** How often a hidden page is woken for worlds that run hidden, milliseconds (browsers allow no more). */
const HIDDEN_INTERVAL = 1000;

/** What the loop drives. */
export interface Driven {
  /** Advances and draws; whether it needs another frame. `hidden`: nobody sees the page. */
  frame(seconds: number, hidden: boolean): boolean;
}

/** The page's animation frames while something is awake; at rest there are none. */
class Loop {
  readonly #driven = new Set<Driven>();
  #request = 0;
  #timer: ReturnType<typeof setTimeout> | undefined;
  #last: number | undefined;

  add(driven: Driven): void {
    if (this.#driven.size === 0) document.addEventListener('visibilitychange', this.turn);
    this.#driven.add(driven);
    this.wake();
  }

  delete(driven: Driven): void {
    this.#driven.delete(driven);
    if (this.#driven.size === 0) document.removeEventListener('visibilitychange', this.turn);
  }

  wake(): void {
    if (document.hidden) this.#timer ??= setTimeout(this.#hiddenFrame, HIDDEN_INTERVAL);
    else if (!this.#request) this.#request = requestAnimationFrame(this.#frame);
  }

  /** The page was hidden or shown: what runs all the same has run until now, what does not has stood since its last frame. */
  readonly turn = (): void => {
    clearTimeout(this.#timer);
    this.#timer = undefined;
    if (this.#last !== undefined) this.#run(performance.now(), true);
    this.wake();
  };

  readonly #frame = (now: number): void => {
    this.#request = 0;
    this.#run(now, document.hidden);
  };

  readonly #hiddenFrame = (): void => {
    this.#timer = undefined;
    if (document.hidden) this.#run(performance.now(), true);
  };

  #run(now: number, hidden: boolean): void {
    const last = this.#last ?? now;
    // A frame may have begun before the turn that it follows: what passed between them passes once.
    this.#last = Math.max(last, now);
    const passed = (this.#last - last) / 1000;
    let again = false;
    for (const driven of this.#driven)
      if (driven.frame(Math.min(passed, hidden ? 2 * LONGEST : LONGEST), hidden)) again = true;
    if (again) this.wake();
    else this.#last = undefined;
  }
}

export const loop = new Loop();
