import { ContactPoint } from '../../engine/contact-point.js';
import { add, scale } from '../../base/math.js';
import type { Body } from '../../dynamics/body.js';
import type { Simulation } from '../../dynamics/simulation.js';
import type { Vec3 } from '../../fields/types.js';
import { eachContactPoint, TOUCHING } from '../contacts/contact-points.js';
import { COLOR } from './colors.js';
import type { DebugLines } from './debug-lines.js';

/** Numbers of a contact point as it is told: the ids of its bodies, where it lies on the second, its normal, its distance. */
const SEEN = 9;

type Visit = (a: Body, b: Body, at: Vec3, normal: Vec3, distance: number) => void;

/** A cross at each contact point, on the surface of the second body, and the normal from there into the first. */
export function markContacts(
  lines: DebugLines,
  simulation: Simulation,
  seen: Float64Array | undefined,
): void {
  const mark: Visit = (a, b, place, normal, distance) => {
    const at = add(place, simulation.poses.origin);
    const size = Math.min(lines.markOn(a), lines.markOn(b));
    const color = distance <= TOUCHING ? COLOR.contact : COLOR.near;
    const arm = size / 4;
    lines.cross(
      at,
      [
        [arm, 0, 0],
        [0, arm, 0],
        [0, 0, arm],
      ],
      color,
    );
    lines.line(at, add(at, scale(normal, 2 * size)), color);
  };
  if (seen) eachSeen(simulation, seen, mark);
  else eachContact(simulation, mark);
}

function eachContact(simulation: Simulation, visit: Visit): void {
  const point = new ContactPoint(simulation.engine.ammo);
  eachContactPoint(simulation, (pointer, a, b) => {
    point.at(pointer, a.pointer, b.pointer);
    visit(a, b, point.positionVector(), point.normalVector(), point.distance);
  });
}

/** For another thread, which draws them. */
export function seeContacts(simulation: Simulation): Float64Array {
  const seen: number[] = [];
  eachContact(simulation, (a, b, at, normal, distance) =>
    seen.push(a.id, b.id, ...at, ...normal, distance),
  );
  return Float64Array.from(seen);
}

function eachSeen({ bodies }: Simulation, seen: Float64Array, visit: Visit): void {
  const byId = new Map([...bodies].map((body) => [body.id, body]));
  const vectorAt = (at: number): Vec3 => [seen[at]!, seen[at + 1]!, seen[at + 2]!];
  for (let at = 0; at < seen.length; at += SEEN) {
    const a = byId.get(seen[at]!);
    const b = byId.get(seen[at + 1]!);
    if (a && b) visit(a, b, vectorAt(at + 2), vectorAt(at + 5), seen[at + 8]!);
  }
}
