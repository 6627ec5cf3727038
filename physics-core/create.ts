// A world without a page: all code is there from the start.
import type { Chunk } from './base/chunk.js';
import { loadEngine as loadBullet, type Engine } from './engine/engine.js';
import type { EngineSource, LoadOptions } from './engine/wasm.js';
import { advice, chunks, World, type WorldOptions } from './inside.js';
import { recordings } from './world/recording.js';
import { dense } from './world/snapshot/dense.js';

/** Code that pages have no words for: the entry `core` adds it. */
export const beyondPages: Chunk<unknown>[] = [];

/** The engine, and the code of all effects: nothing that is made of them waits. */
export async function loadEngine(options: LoadOptions = {}): Promise<Engine> {
  const all = [advice, recordings, dense, ...beyondPages, ...chunks].map((chunk) => chunk.load());
  const [engine] = await Promise.all([loadBullet(options), ...all]);
  return engine;
}

export interface CreateOptions extends WorldOptions, Pick<EngineSource, 'wasmUrl' | 'wasmBinary'> {
  [field: string]: unknown;
}

/**
 * A world without a page. The options are the fields of RigidBodyCollection, and `maxHeapBytes`.
 * @example
 * const world = await createWorld({ gravity: [0, -9.8, 0] });
 * const ball = world.add('RigidBody', { position: [0, 5, 0], geometry: [{ type: 'Sphere', radius: 0.5 }] });
 * world.advance(1);
 */
export async function createWorld(options: CreateOptions = {}): Promise<World> {
  const { wasmUrl, wasmBinary, console, maxHeapBytes, ...fields } = options;
  const engine = await loadEngine({ wasmUrl, wasmBinary });
  const world = new World({
    console: console ?? false,
    ...(maxHeapBytes === undefined ? {} : { maxHeapBytes }),
  });
  world.add('RigidBodyCollection', fields);
  world.start(engine);
  return world;
}
