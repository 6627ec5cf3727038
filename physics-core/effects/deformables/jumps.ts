import type { Deformable } from './deformable.js';
import type { Tied } from './ties.js';

// What a cloth or a soft body is tied to is suddenly elsewhere: an edit, no motion, and nothing gets a speed by it.

/** It goes along with all that holds it; where only some of that jumps, it goes to where its threads let it. */
export function followJumps(deformable: Deformable, ties: readonly Tied[]): void {
  const { settings } = deformable;
  if (settings.fixed.length === 0 && ties.every(({ jumps }) => jumps)) carry(deformable, ties);
  for (const tied of ties) tied.pin();
  deformable.settle();
}

/** By the mean of what holds it. */
function carry({ material }: Deformable, ties: readonly Tied[]): void {
  const { count, inverse, places } = material.masses;
  const way = [0, 1, 2].map((k) => ties.reduce((sum, { jump }) => sum + jump[k]!, 0) / ties.length);
  for (let i = 0; i < count; i++)
    if (inverse[i]! > 0) for (let k = 0; k < 3; k++) places[3 * i + k]! += way[k]!;
}
