/** How much time steps have passed. */
export class StepTime {
  /** Steps since the step last changed its length, and the time that was then: sums of steps would round. */
  #steps = 0;
  #before = 0;
  /** Seconds of the last step; undefined: there was none yet. */
  last: number | undefined;
  /** Steps of Bullet so far, whatever became of time. */
  taken = 0;

  /** Seconds, with steps of this length. */
  at(timeStep: number): number {
    return this.#before + this.#steps * timeStep;
  }

  set(time: number): void {
    this.#before = time;
    this.#steps = 0;
  }

  /** A step in which nothing moved. */
  pass(): void {
    this.#steps++;
  }

  /** A step of Bullet. */
  count(timeStep: number): void {
    this.#steps++;
    this.taken++;
    this.last = timeStep;
  }
}
