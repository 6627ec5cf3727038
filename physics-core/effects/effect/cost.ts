/**
 * One step in so many is measured: often enough to follow, too seldom to cost anything, and prime, so that what acts in
 * each second or fourth step is met as often as not.
 */
export const MEASURED_EVERY = 17;

/** Weight of the newest measurement in the running means; the first ones weigh alike. */
const NEWEST = 0.05;

/** What an effect costs per step; what acts once per frame, per frame. Running means. */
export class EffectCost {
  ms = 0;
  /** Of its hooks. */
  calls = 0;
  #measured = 0;
  /** Of the present step. */
  called = 0;
  #spent = 0;

  /** A call that began at `start` is over. */
  add(start: number): void {
    this.#spent += performance.now() - start;
    this.called++;
  }

  /** A step that is measured is over. */
  note(): void {
    const weight = Math.max(NEWEST, 1 / ++this.#measured);
    this.ms += (this.#spent - this.ms) * weight;
    this.calls += (this.called - this.calls) * weight;
    this.#spent = this.called = 0;
  }
}
