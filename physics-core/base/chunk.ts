/** What a chunk's file exports. */
export interface ChunkFile<Code> {
  /** Called once, when it is here. */
  provide(): Code;
  /** What came with it, bytes as a server sends them (gzip): the build says so. */
  readonly bytes?: number;
}

/** Code that a scene may do without: a file of its own, fetched when its cause stands in a scene. */
export class Chunk<Code = void> {
  readonly name!: string;
  /** What has it fetched, for people. */
  readonly causes!: string;
  #fetch: (() => Promise<ChunkFile<Code>>) | undefined;
  #coming: Promise<void> | undefined;
  /** Bytes of a file that is fetched for the same cause beside its own. */
  #beside = 0;
  #come: { code: Code; bytes: number } | undefined;

  constructor(about: { name: string; causes: string }) {
    Object.assign(this, about);
  }

  /** Where its file is: said by a room that sees all of it. */
  comesFrom(fetch: () => Promise<ChunkFile<Code>>): this {
    this.#fetch = fetch;
    return this;
  }

  get here(): boolean {
    return this.#come !== undefined;
  }

  /** What was fetched for it: nothing before it is here, and where all code is one file. */
  get bytes(): number {
    return (this.#come?.bytes ?? 0) + this.#beside;
  }

  /** A file of so many bytes is fetched for the same cause, too. */
  comesWith(bytes: number): void {
    this.#beside = bytes;
  }

  /** For those that are not made before it is here. */
  get code(): Code {
    if (!this.#come) throw new Error(`the code of "${this.name}" is asked for before it is here`);
    return this.#come.code;
  }

  /** Now where it is here; else as soon as it is, and never where it does not come. */
  whenHere(act: () => void): void {
    if (this.here) act();
    else this.load().then(act, () => {});
  }

  /** Fetched once; what failed may be tried again. */
  load(): Promise<void> {
    return (this.#coming ??= this.#load());
  }

  async #load(): Promise<void> {
    try {
      const file = await this.#fetch!();
      this.#come = { code: file.provide(), bytes: file.bytes ?? 0 };
    } catch (error) {
      this.#coming = undefined;
      throw error;
    }
  }
}
