/** How often in a row something was found. */
export class Streaks {
  #before = new Map<number, number>();
  #now = new Map<number, number>();

  /** The next look: what it does not find has no streak any more. */
  begin(): void {
    const now = this.#before;
    this.#before = this.#now;
    this.#now = now;
    now.clear();
  }

  /** Found once more; returns how often in a row. */
  note(key: number): number {
    const count = (this.#before.get(key) ?? 0) + 1;
    this.#now.set(key, count);
    return count;
  }

  forget(): void {
    this.#before.clear();
    this.#now.clear();
  }
}
