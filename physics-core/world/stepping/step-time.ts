/** How much time steps have passed. */
export class StepTime {
  /** Steps since the step last changed its length, and the time that was then: sums of steps would round. */
  #steps = 0;
  #before = 0;
  /** Of the step that is under way: parts that are over, of so many. */
  #within = 0;
  #parts = 1;
  /** Seconds of the last step; undefined: there was none yet. */
  last: number | undefined;
  /** Steps of Bullet so far, whatever became of time. */
  taken = 0;

  /** Seconds, with steps of this length. */
  at(timeStep: number): number {
    return this.#before + (this.#steps + this.#within / this.#parts) * timeStep;
  }

  set(time: number): void {
    this.#before = time;
    this.#steps = this.#within = 0;
  }

  /** A step in which nothing moved. */
  pass(): void {
    this.#steps++;
  }

  /** A step of Bullet: one of so many parts of a step of this length. */
  count(timeStep: number, parts: number): void {
    this.#within++;
    this.taken++;
    this.#parts = parts;
    if (this.#within < parts) return;
    this.#within = 0;
    this.#steps++;
    this.last = timeStep;
  }
}
