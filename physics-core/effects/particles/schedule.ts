/** Share of the time between two births: what rounding of their sums leaves, in weeks. */
const SAME_TIME = 1e-6;

/** When particles of a system are born, and which of them make room: as many are born as die, when all that may live do. */
export class Schedule {
  /** When the next one is born, seconds of its system, and which number it has. */
  due = 0;
  next = 0;
  /** Seconds from birth to birth. */
  #interval = Infinity;
  /** When those died that this step saw die, seconds; how many they are, and how many of them are dead at the next birth. */
  #deaths = new Float64Array(16);
  #died = 0;
  #gone = 0;

  /**
   * `most` live at once, each so many seconds; the next one is born within one interval from now. Where that is so but for
   * rounding it stays when it is: who hears the same again bears the same.
   */
  takeRate(most: number, lifetime: number, now: number): void {
    this.#interval = most >= 1 && lifetime > 0 ? lifetime / most : Infinity;
    const latest = now + this.#interval;
    if (this.due > latest + this.sameTime) this.due = latest;
  }

  /** Where all live as long, each is born when another dies: sums of the same times differ in their last digits. */
  get sameTime(): number {
    return Number.isFinite(this.#interval) ? SAME_TIME * this.#interval : 0;
  }

  /** One was born, or found no room. */
  pass(atOnce: boolean): void {
    this.next++;
    if (!atOnce) this.due += this.#interval;
  }

  /** Those that are born and die before `end`, since they live `longest` at most, are not seen by anybody. */
  passOver(end: number, longest: number): void {
    const over = Math.floor((end - longest - this.due) / this.#interval);
    if (!(over > 0)) return;
    // What lives so briefly that nobody could count it is nowhere.
    const counted = over < Number.MAX_SAFE_INTEGER;
    if (counted) this.next += over;
    this.due = counted ? this.due + over * this.#interval : end;
  }

  // ---- deaths of a step -------------------------------------------------------------------------------------------

  /** A step begins, in which nobody has died yet. */
  beginStep(): void {
    this.#died = this.#gone = 0;
  }

  noteDeath(time: number): void {
    if (this.#died === this.#deaths.length) {
      const more = new Float64Array(2 * this.#died);
      more.set(this.#deaths);
      this.#deaths = more;
    }
    this.#deaths[this.#died++] = time;
  }

  sortDeaths(): void {
    this.#deaths.subarray(0, this.#died).sort();
  }

  /** How many of those that died in this step still live when the next one is due. */
  get stillLiving(): number {
    const until = this.due + this.sameTime;
    while (this.#gone < this.#died && this.#deaths[this.#gone]! <= until) this.#gone++;
    return this.#died - this.#gone;
  }
}
