import { ContactPoint } from '../../engine/contact-point.js';
import { add, scale } from '../../base/math.js';
import type { Simulation } from '../../dynamics/simulation.js';
import { eachContactPoint, TOUCHING } from '../contacts/contact-points.js';
import { COLOR } from './colors.js';
import type { DebugLines } from './debug-lines.js';

/** A cross at each contact point, on the surface of the second body, and the normal from there into the first. */
export function markContacts(lines: DebugLines, simulation: Simulation): void {
  if (!simulation.engine.heapTrusted) return;
  const point = new ContactPoint(simulation.engine.ammo);
  eachContactPoint(simulation, (pointer, a, b) => {
    point.at(pointer, a.pointer, b.pointer);
    const at = add(point.positionVector(), simulation.poses.origin);
    const normal = point.normalVector();
    const size = Math.min(lines.markOn(a), lines.markOn(b));
    const color = point.distance <= TOUCHING ? COLOR.contact : COLOR.near;
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
  });
}
