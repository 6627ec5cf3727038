/** One call of a function of the core, or of Bullet. */
export interface Call {
  /** Below physics-core; BULLET for what Ammo does. */
  file: string;
  name: string;
  /** Who called it; undefined: somebody outside the core. */
  caller: Call | undefined;
  /** On what it was called, and with what, where that is known. */
  on?: unknown;
  with?: ArrayLike<unknown>;
}

export const BULLET = 'Bullet';

/** What the instrumented core tells of its calls; kept while somebody records. */
class Recorder {
  #calls: Call[] | undefined;
  readonly #stack: Call[] = [];

  enter(file: string, name: string, on?: unknown, args?: ArrayLike<unknown>): void {
    if (!this.#calls) return;
    const call: Call = { file, name, caller: this.#stack.at(-1), on, with: args };
    this.#calls.push(call);
    this.#stack.push(call);
  }

  exit(): void {
    if (this.#calls) this.#stack.pop();
  }

  /** The calls that some work makes, in their order. */
  record(work: () => void): Call[] {
    const calls: Call[] = [];
    this.#calls = calls;
    try {
      work();
    } finally {
      this.#calls = undefined;
      this.#stack.length = 0;
    }
    return calls;
  }
}

export const recorder = new Recorder();
