import type { BodiesWorld } from './bodies.js';
import { jointsOf, nodesOf } from './states.js';
import { HOW, PARKED, type Moment, type Snapshot } from './snapshot.js';

/** The world that goes back. */
interface SameWorld extends BodiesWorld {
  readonly accuracy: string;
  readonly control: { readonly parts: number };
}

/** Whether all that stands in Bullet is as it was, but for where it is: nothing is to be made anew. */
export function isSame(
  world: SameWorld,
  { level, parts, origin, nodes, joints }: Snapshot,
  { ids, flags }: Moment,
): boolean {
  const built = new Map([...world.bodies].map((body) => [body.id, body]));
  return (
    world.accuracy === level &&
    world.control.parts === parts &&
    alike(world.poses.origin, origin) &&
    alike(nodesOf(world, nodes), nodes) &&
    // Wherever their stops were met.
    alike(jointsOf(world).map(placed), joints.map(placed)) &&
    ids.length === built.size &&
    ids.every((id, i) => built.get(id)?.presence.parked === (flags[i]! % HOW === PARKED))
  );
}

const placed = ([id, { rows, ...zero }]: Snapshot['joints'][number]): unknown => [
  id,
  zero,
  { ...rows, stops: rows.stops.length },
];

/** Plain data, that may have gone through JSON. */
export function alike(one: unknown, other: unknown): boolean {
  if (one === other || typeof one !== 'object' || one === null) return one === other;
  if (typeof other !== 'object' || other === null) return false;
  const names = Object.keys(one);
  return (
    names.length === Object.keys(other).length &&
    names.every((name) => alike(one[name as never], other[name as never]))
  );
}
