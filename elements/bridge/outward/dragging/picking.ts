import type { RayHit, Vec3 } from '../../../../physics-core/inside.js';
import { ownBinding, type Binding } from '../../nodes/binding.js';
import type { PageWorld } from '../../nodes/surroundings.js';
import type { Stage } from '../stage.js';
import type { DraggableBody } from '../body.js';
import type { Sight } from './view.js';

/** A draggable body under the pointer, and the point of it, metres. */
export interface Picked {
  body: DraggableBody;
  binding: Binding;
  point: Vec3;
}

/** The element's binding of a body. */
export const bindingOf = (body: DraggableBody): Binding | undefined =>
  body.host instanceof Element ? ownBinding(body.host) : undefined;

/** Metres of one length of the scene, as the file of a body has it. */
export const metresOf = (binding: Binding): number => binding.units.length;

export const scaled = ([x, y, z]: Vec3, by: number): Vec3 => [x * by, y * by, z * by];

/**
 * What Bullet has under the pointer, to the shape: x3dom would tell the drawn surface, but of one pixel, and in a picture of
 * its own. What may not be dragged hides what is behind it.
 */
export function pick(stage: Stage, sight: Sight): Picked | undefined {
  const { bodies } = stage.draggables;
  let nearest = Infinity;
  let picked: Picked | undefined;
  for (const metres of lengths(bodies)) {
    for (const world of stage.worlds.all) {
      const hit = shownBy(world, scaled(sight.from, metres), scaled(sight.to, metres));
      if (!hit || hit.fraction >= nearest) continue;
      const body = hit.node as DraggableBody;
      const binding = bindingOf(body);
      // Files with another unit of length are drawn in another scale.
      if (!binding || metresOf(binding) !== metres) continue;
      nearest = hit.fraction;
      picked = bodies.has(body) ? { body, binding, point: hit.position } : undefined;
    }
  }
  return picked;
}

/** Where a world runs in a worker, that is what came back from there last: nobody can aim at anything else. */
function shownBy(world: PageWorld, from: Vec3, to: Vec3): RayHit | null {
  world.elsewhere?.place();
  return world.rays.cast(from, to);
}

function lengths(bodies: Iterable<DraggableBody>): Set<number> {
  const found = new Set<number>();
  for (const body of bodies) {
    const binding = bindingOf(body);
    if (binding) found.add(metresOf(binding));
  }
  return found;
}
