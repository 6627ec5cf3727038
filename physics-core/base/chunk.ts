/** What a chunk's file exports: gives its code to those who wait for it. */
export interface ChunkCode {
  provide(): void;
}

/** Code that a scene may do without: a file of its own, fetched when its cause stands in a scene. */
export class Chunk {
  readonly name: string;
  /** What has it fetched, for people. */
  readonly causes: string;
  #fetch: (() => Promise<ChunkCode>) | undefined;
  #coming: Promise<void> | undefined;
  #here = false;

  constructor(name: string, causes: string) {
    this.name = name;
    this.causes = causes;
  }

  /** Where its code is: said by a room that sees all of it. */
  comesFrom(fetch: () => Promise<ChunkCode>): this {
    this.#fetch = fetch;
    return this;
  }

  get here(): boolean {
    return this.#here;
  }

  /** Fetched once; what failed may be tried again. */
  load(): Promise<void> {
    return (this.#coming ??= this.#load());
  }

  async #load(): Promise<void> {
    try {
      const { provide } = await this.#fetch!();
      provide();
      this.#here = true;
    } catch (error) {
      this.#coming = undefined;
      throw error;
    }
  }
}
