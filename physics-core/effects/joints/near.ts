import type { Body } from '../../dynamics/body.js';
import type { Simulation } from '../../dynamics/simulation.js';

/** Whether Bullet watches for contacts of two bodies: they are near each other. */
export function areNear({ bullet }: Simulation, a: Body, b: Body): boolean {
  let near = false;
  bullet.eachPair((_, first, second) => {
    if (first === a.pointer ? second === b.pointer : first === b.pointer && second === a.pointer)
      near = true;
  });
  return near;
}
