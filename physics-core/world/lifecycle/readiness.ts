/** A promise that a world has started, which may be made anew after an attempt that failed. */
export class Readiness<W> {
  #promise!: Promise<W>;
  #settle: { resolve: (world: W) => void; reject: (problem: unknown) => void } | undefined;

  constructor() {
    this.await();
  }

  get promise(): Promise<W> {
    return this.#promise;
  }

  /** After a failed attempt: who asks from now on hears how the next one ends. */
  await(): void {
    if (this.#settle) return;
    this.#promise = new Promise((resolve, reject) => (this.#settle = { resolve, reject }));
    // Nobody need listen; who awaits still hears.
    this.#promise.catch(() => {});
  }

  resolve(world: W): void {
    this.await();
    this.#settle!.resolve(world);
  }

  reject(problem: unknown): void {
    this.#settle?.reject(problem);
    this.#settle = undefined;
  }
}
