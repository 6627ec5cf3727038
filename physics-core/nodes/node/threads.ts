import { Chunk } from '../../base/chunk.js';
import type { NodeWorld } from './node-world.js';

/** What a world needs to run on another thread, in a room above that of worlds. */
interface ThreadCode {
  /** A world begins, or begins anew: it takes its thread. */
  choose(world: NodeWorld): void;
  /** Asks a world on whichever thread it runs. */
  ask(world: NodeWorld, method: string, args: readonly unknown[]): Promise<unknown>;
}

export const threads = new Chunk<ThreadCode>({ name: 'thread', causes: '`thread`' });
