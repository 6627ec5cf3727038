import type { PageWorld } from '../nodes/surroundings.js';

interface Drawn {
  draw(): void;
}

const all = new WeakMap<PageWorld, Set<Drawn>>();

/** What is drawn of a world beside its bodies, in each of its frames. */
export function drawingsIn(world: PageWorld): Set<Drawn> {
  const known = all.get(world);
  if (known) return known;
  const drawings = new Set<Drawn>();
  all.set(world, drawings);
  const { onshow } = world;
  world.onshow = () => {
    onshow?.();
    for (const each of drawings) each.draw();
  };
  return drawings;
}
