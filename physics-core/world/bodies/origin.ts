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

/** Where Bullet counts from: in the middle of the bodies, if that is far. Some that are elsewhere do not count. */
export function originFor(nodes: Iterable<PhysicsNode>): Vec3 {
  const places = [...nodes].flatMap((node) => (node instanceof BodyNode ? placeOf(node) : []));
  const middle = [0, 1, 2].map((axis) => median(places.map((place) => place[axis]!))) as Vec3;
  if (guards.near(length(middle), NEAR)) return [0, 0, 0];
  return middle.map((x) => GRID * Math.round(x / GRID)) as Vec3;
}

/** Where it starts, as far as that is known. */
function placeOf(body: BodyNode): Vec3[] {
  const place = body.authored('position') ? body.asked<Vec3>('position') : body.motion.start?.p;
  return place && guards.bounded(place, BOUNDS.plain) ? [place] : [];
}

function median(numbers: number[]): number {
  const sorted = numbers.toSorted((a, b) => a - b);
  return sorted[Math.floor(sorted.length / 2)] ?? 0;
}
