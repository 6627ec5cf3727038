import assert from 'node:assert/strict';
import type { World } from '../../physics-core/inside.js';

interface Heap {
  _malloc(bytes: number): number;
}

/** Rounds that fill holes which earlier work left. */
const ROUNDS = 6;

/** How much more work is to take as much. */
const MORE = 4;

/**
 * Runs the same work several times and takes a block of the heap for good in between. What lives on may move past it and
 * leave a hole, by every block the same; what leaks comes on top of that with each time: where nothing does, blocks lie as
 * far apart after much work as after little.
 */
export async function leavesNoTrace(w: World, work: () => void | Promise<void>): Promise<void> {
  const take = () => (w.engine.ammo as unknown as Heap)._malloc(65536);
  const worked = async (times: number): Promise<number> => {
    const before = take();
    for (let i = 0; i < times; i++) await work();
    return take() - before;
  };
  for (let i = 0; i < ROUNDS; i++) {
    await work();
    take();
  }
  const little = await worked(1);
  const size = w.engine.heapBytes;
  assert.equal(await worked(MORE), little, 'bytes between two blocks');
  assert.equal(w.engine.heapBytes, size);
}
