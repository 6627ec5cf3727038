import { existsSync } from 'node:fs';
import { builtFiles } from '../../tools/docs/effects/chunks.js';

const CORE = new URL('../../dist/core.js', import.meta.url);

/** What the files of the build weigh, bytes as a server sends them (gzip). */
export class Bytes {
  readonly #chunks: ReadonlyMap<string, number>;

  private constructor(chunks: ReadonlyMap<string, number>) {
    this.#chunks = chunks;
  }

  /** As the built core says it itself, in `world.effects`. */
  static async read(): Promise<Bytes> {
    if (!existsSync(CORE)) throw new Error('dist/ is not there: npm run build makes it');
    const { createWorld } = (await import(
      CORE.href
    )) as typeof import('../../physics-core/index.js');
    const world = await createWorld();
    const { effects } = world;
    world.destroy();
    return new Bytes(
      new Map(effects.flatMap(({ chunk, bytes }) => (chunk ? [[chunk, bytes]] : []))),
    );
  }

  /** Of these files, or of what the chunk of that name comes in. */
  of(files: readonly string[] | undefined, chunk: string | null): number {
    if (files) return files.reduce((sum, file) => sum + this.#ofFile(file), 0);
    return chunk === null ? 0 : this.#ofChunk(chunk);
  }

  #ofChunk(name: string): number {
    const bytes = this.#chunks.get(name);
    if (!bytes) throw new Error(`the build has no chunk ${name}: npm run build makes it anew`);
    return bytes;
  }

  /** By how its name begins. */
  #ofFile(begin: string): number {
    const file = builtFiles().find(({ name }) => name.startsWith(begin));
    if (!file) throw new Error(`the build has no file ${begin}`);
    return file.bytes;
  }
}
