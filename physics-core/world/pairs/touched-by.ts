import type { Body } from '../../dynamics/body.js';
import type { Simulation } from '../../dynamics/simulation.js';
import { ContactPoint } from '../../engine/contact-point.js';
import { eachContactPoint } from '../../effects/contacts/contact-points.js';
import { BEGIN } from '../../effects/contacts/touches.js';

/** What a body touches now. */
export function touchedBy(simulation: Simulation, body: Body): Set<Body> {
  const others = new Set<Body>();
  const point = new ContactPoint(simulation.engine.ammo);
  eachContactPoint(simulation, (pointer, a, b) => {
    if (a !== body && b !== body) return;
    if (point.at(pointer, a.pointer, b.pointer).distance <= BEGIN) others.add(a === body ? b : a);
  });
  return others;
}
