import type { Vec3 } from '../../fields/types.js';
import { guards } from '../../base/guards.js';
import { length } from '../../base/math.js';
import { BOUNDS } from '../../fields/bounds.js';
import { BodyNode } from '../../nodes/body/body.js';
import type { PhysicsNode } from '../../nodes/node/node.js';

/** Nearer than that to the author's 0 0 0 nothing is gained, metres: single precision has steps of 0.06 mm there. */
const NEAR = 1000;

/** Whole so many metres: round numbers stay as round as they are. */
const GRID = 16;

/** Where Bullet counts from: in the middle of what moves, if that is far. Some that are elsewhere do not count. */
export function originFor(first: BodyNode, nodes: Iterable<PhysicsNode>): Vec3 {
  const bodies = [...nodes].filter((node) => node instanceof BodyNode);
  const moving = bodies.filter(({ movable }) => movable);
  // One that stands for a collidable is none of the nodes.
  const decisive = moving.length > 0 ? moving : bodies.length > 0 ? bodies : [first];
  const places = decisive.flatMap(placesOf);
  const middle = [0, 1, 2].map((axis) => median(places.map((place) => place[axis]!))) as Vec3;
  if (guards.near(length(middle), NEAR)) return [0, 0, 0];
  return middle.map((x) => GRID * Math.round(x / GRID)) as Vec3;
}

/** Where it starts, as far as that is known. */
function placesOf(body: BodyNode): Vec3[] {
  const start =
    body.motion.start ?? body.geometry.collidables.find((one) => one.startPose)?.startPose;
  const place = body.authored('position') ? body.asked<Vec3>('position') : start?.p;
  return place && guards.bounded(place, BOUNDS.plain) ? [place] : [];
}

/** Of two middle ones that which is nearer to 0. */
function median(numbers: number[]): number {
  const sorted = numbers.toSorted((a, b) => a - b);
  const low = sorted[(sorted.length - 1) >> 1] ?? 0;
  const high = sorted[sorted.length >> 1] ?? 0;
  return Math.abs(low) < Math.abs(high) ? low : high;
}
