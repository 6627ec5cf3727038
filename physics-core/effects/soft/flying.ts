import { dot3 } from '../../base/flat-math.js';
import { nearestOnSegments } from '../../base/segments.js';
import type { Simulation } from '../../dynamics/simulation.js';
import { VELOCITY } from '../../engine/moving-bodies.js';
import type { Rope } from './rope.js';
import { AHEAD } from './tolerances.js';

const path = new Float64Array(6);
const shares = new Float64Array(2);
const box = new Float64Array(6);

/** Tells of a link that a body may fly into in this step, and at which share of it. */
export type Flight = (rope: Rope, link: number, share: number, slot: number) => void;

/**
 * Bodies that go farther in a step than a rope looks about: one that is small would be on its other side before it was seen.
 * Where one comes near, it is looked for on its way.
 */
export class Flying {
  readonly #simulation: Simulation;

  constructor(simulation: Simulation) {
    this.#simulation = simulation;
  }

  look(rope: Rope, dt: number, tell: Flight): void {
    const { bodies } = this.#simulation;
    const { slots, pointers, asleep, velocities } = bodies.moving;
    const least = (AHEAD * rope.settings.radius) ** 2;
    let isBoxed = false;
    for (let slot = 0; slot < slots; slot++) {
      if (pointers[slot] === 0 || asleep[slot] === 1) continue;
      const v = slot * VELOCITY;
      if (!(dt * dt * dot3(velocities, v, velocities, v) > least)) continue;
      if (!isBoxed) surround(rope);
      isBoxed = true;
      this.#pass(rope, slot, dt, tell);
    }
  }

  #pass(rope: Rope, slot: number, dt: number, tell: Flight): void {
    const { bodies } = this.#simulation;
    const body = bodies.in(slot)!;
    const { velocities } = bodies.moving;
    const centre = body.centerOfMassWorld();
    const reach = body.reach + 2 * rope.settings.radius;
    for (let k = 0; k < 3; k++) {
      const way = dt * velocities[slot * VELOCITY + k]!;
      const low = Math.min(centre[k]!, centre[k]! + way) - reach;
      const high = Math.max(centre[k]!, centre[k]! + way) + reach;
      if (!(low <= box[3 + k]! && high >= box[k]!)) return;
    }
    const { places, free, points } = rope.strand;
    for (let i = 0; i < points - 1; i++) {
      for (let k = 0; k < 3; k++) {
        const j = 3 * i + k;
        path[k] = centre[k]!;
        const v = velocities[slot * VELOCITY + k]! - (free[j]! + free[j + 3]!) / 2;
        path[3 + k] = centre[k]! + dt * v;
      }
      nearestOnSegments(places, 3 * i, 3 * i + 3, path, 0, 3, shares);
      let square = 0;
      for (let k = 0; k < 3; k++) {
        const j = 3 * i + k;
        const on = places[j]! + shares[0]! * (places[j + 3]! - places[j]!);
        square += (on - path[k]! - shares[1]! * (path[3 + k]! - path[k]!)) ** 2;
      }
      if (square < reach * reach) tell(rope, i, shares[0]!, slot);
    }
  }
}

/** The box around a rope. */
function surround({ strand: { places } }: Rope): void {
  for (let k = 0; k < 3; k++) {
    let low = Infinity;
    let high = -Infinity;
    for (let j = k; j < places.length; j += 3) {
      if (places[j]! < low) low = places[j]!;
      if (places[j]! > high) high = places[j]!;
    }
    box[k] = low;
    box[3 + k] = high;
  }
}
