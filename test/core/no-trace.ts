import assert from 'node:assert/strict';
import type { World } from '../../physics-core/inside.js';

interface Heap {
  _malloc(bytes: number): number;
}

/**
 * Runs the same work several times and takes a block of the heap for good after each: where nothing leaks, the last
 * two lie exactly as far apart as two taken with nothing between them. The first rounds fill holes.
 */
export async function leavesNoTrace(w: World, work: () => void | Promise<void>): Promise<void> {
  const take = () => (w.engine.ammo as unknown as Heap)._malloc(65536);
  for (let i = 0; i < 3; i++) {
    await work();
    take();
  }
  const [first, second] = [take(), take()];
  await work();
  take();
  const size = w.engine.heapBytes;
  const before = take();
  await work();
  assert.equal(take() - before, second - first, 'bytes between two blocks');
  assert.equal(w.engine.heapBytes, size);
}
