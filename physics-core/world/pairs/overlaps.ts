import { isFiltered } from '../../effects/contacts/contact-points.js';
import { ContactPoint } from '../../engine/contact-point.js';
import { eachPoint } from '../../engine/manifold.js';
import type { Body } from '../../dynamics/body.js';
import type { Simulation } from '../../dynamics/simulation.js';

/** Bodies that begin deeper in each other than this are worth a word, metres. */
const DEEP = 0.02;

/** How deep each pair of bodies overlaps that may touch, metres; negative is a gap. */
function eachDepth(simulation: Simulation, visit: (depth: number, a: Body, b: Body) => void): void {
  const { ammo } = simulation.engine;
  const point = new ContactPoint(ammo);
  simulation.bullet.eachPair((manifold, a, b) => {
    const first = simulation.bodyAt(a);
    const second = simulation.bodyAt(b);
    if (!first || !second || !(first.movable || second.movable)) return;
    let depth = -Infinity;
    eachPoint(ammo, manifold, (pointer) => {
      // Not the distance that Bullet holds: contact parameters write into it.
      if (!isFiltered(ammo, pointer)) depth = Math.max(depth, -point.at(pointer, a, b).distance);
    });
    visit(depth, first, second);
  });
}

/** Metres; 0 where nothing overlaps. */
export function deepestOverlap(simulation: Simulation): number {
  let deepest = 0;
  eachDepth(simulation, (depth) => (deepest = Math.max(deepest, depth)));
  return deepest;
}

/** Tells of bodies that the first step found inside each other: they are pushed apart, which is seldom meant. */
export function reportOverlaps(simulation: Simulation): void {
  eachDepth(simulation, (depth, first, second) => {
    if (depth <= DEEP) return;
    simulation.report(
      {
        code: 'initial-overlap',
        severity: 'info',
        attribute: 'position',
        value: depth,
        used: 'pushed apart',
        message: `${first.label} and ${second.label} begin ${depth.toFixed(2)} m inside each other and are pushed apart`,
      },
      first.movable ? first : second,
    );
  });
}
