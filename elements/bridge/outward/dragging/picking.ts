import type { PhysicsNode, Vec3 } from '../../../../physics-core/inside.js';
import { ownBinding, type Binding } from '../../nodes/binding.js';
import type { PageWorld } from '../../nodes/surroundings.js';
import type { Stage } from '../stage.js';
import type { DraggableBody, Seen } from '../body.js';
import type { Sight } from './view.js';

/** What may be dragged under the pointer, and the point of it, metres. */
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

/** What is under the pointer in one world. */
interface Hit {
  node: PhysicsNode;
  fraction: number;
  position: Vec3;
}

/**
 * What Bullet has under the pointer, to the shape, and what ropes, cloth and soft bodies there are: x3dom would tell the drawn
 * surface, but of one pixel, and in a picture of its own. What may not be dragged hides what is behind it.
 */
export function pick(stage: Stage, sight: Sight): Picked | undefined {
  const { bodies } = stage.draggables;
  let nearest = Infinity;
  let picked: Picked | undefined;
  for (const metres of lengths(bodies)) {
    const inMetres = {
      from: scaled(sight.from, metres),
      to: scaled(sight.to, metres),
      beside: sight.beside.map((each) => each * metres) as [number, number],
    };
    for (const world of stage.worlds.all) {
      for (const { node, fraction, position } of hitsIn(world, inMetres)) {
        if (fraction >= nearest) continue;
        const body = node as DraggableBody;
        const binding = bindingOf(body);
        // Files with another unit of length are drawn in another scale.
        if (!binding || metresOf(binding) !== metres) continue;
        nearest = fraction;
        picked = bodies.has(body) ? { body, binding, point: position } : undefined;
      }
    }
  }
  return picked;
}

/** Where a world runs in a worker, that is what came back from there last: nobody can aim at anything else. */
function* hitsIn(world: PageWorld, sight: Sight): Generator<Hit> {
  const { from, to } = sight;
  world.elsewhere?.place();
  const hit = world.rays.cast(from, to);
  if (hit) yield hit;
  for (const node of world.nodes) {
    const fraction = (node as Seen).seen?.(sight);
    if (fraction === undefined) continue;
    const position = from.map((value, k) => value + fraction * (to[k]! - value)) as Vec3;
    yield { node, fraction, position };
  }
}

function lengths(bodies: Iterable<DraggableBody>): Set<number> {
  const found = new Set<number>();
  for (const body of bodies) {
    const binding = bindingOf(body);
    if (binding) found.add(metresOf(binding));
  }
  return found;
}
