/** What a chunk's file exports. */
export interface ChunkFile<Code> {
  /** Called once, when it is here. */
  provide(): Code;
}

/** Code that a scene may do without: a file of its own, fetched when its cause stands in a scene. */
export class Chunk<Code = void> {
  readonly name: string;
  /** What has it fetched, for people. */
  readonly causes: string;
  #fetch: (() => Promise<ChunkFile<Code>>) | undefined;
  #coming: Promise<void> | undefined;
  #come: { code: Code } | undefined;

  constructor({ name, causes }: { name: string; causes: string }) {
    this.name = name;
    this.causes = causes;
  }

  /** Where its file is: said by a room that sees all of it. */
  comesFrom(fetch: () => Promise<ChunkFile<Code>>): this {
    this.#fetch = fetch;
    return this;
  }

  get here(): boolean {
    return this.#come !== undefined;
  }

  /** For those that are not made before it is here. */
  get code(): Code {
    if (!this.#come) throw new Error(`the code of "${this.name}" is asked for before it is here`);
    return this.#come.code;
  }

  /** Fetched once; what failed may be tried again. */
  load(): Promise<void> {
    return (this.#coming ??= this.#load());
  }

  async #load(): Promise<void> {
    try {
      const { provide } = await this.#fetch!();
      this.#come = { code: provide() };
    } catch (error) {
      this.#coming = undefined;
      throw error;
    }
  }
}
