import { dot3 } from '../../base/flat-math.js';
import type { Simulation } from '../../dynamics/simulation.js';
import { ROPE_RETURN } from '../../solver/tolerances.js';
import { FREE } from '../../solver/ropes/strand.js';
import { MET, METS, Obstacles } from '../particles/collide/obstacles.js';
import type { Rope } from './rope.js';
import type { TiedGroup } from './tied-group.js';
import { AHEAD } from './tolerances.js';
import { TouchedBodies } from './touched-bodies.js';

const met = new Float64Array(METS);
const from = new Float64Array(3);
const to = new Float64Array(3);
const point = new Float64Array(3);
const force = new Float64Array(3);

/** What points of ropes touch in a step, and what they do to it. */
export class RopeTouch {
  readonly #obstacles: Obstacles;
  readonly #bodies: TouchedBodies;

  constructor(simulation: Simulation) {
    this.#obstacles = new Obstacles(simulation);
    this.#bodies = new TouchedBodies(simulation);
  }

  /** Where bodies are when a step begins, however they came there. */
  take(dt: number): void {
    this.#obstacles.forget();
    this.#obstacles.take(dt);
    this.#bodies.begin();
  }

  /** A point is tied to a body, maybe deep within it: so much of the rope does not touch that. */
  comeOut({ strand, settings: { radius }, within }: Rope, index: number, slot: number): void {
    const { places, lengths, points } = strand;
    for (let k = 0; k < 3; k++) from[k] = places[3 * index + k]!;
    const inside = this.#obstacles.meet(from, from, 0, met, 1, 1) && met[MET.body] === slot;
    const most = (inside ? met[MET.depth]! : 0) + 2 * radius;
    let first = index;
    let last = index;
    for (let far = 0; first > 0 && far < most; first--) far += lengths[first - 1]!;
    for (let far = 0; last < points - 1 && far < most; last++) far += lengths[last]!;
    within.push({ slot, first, last });
  }

  /** Who each point may touch in a step that begins. All that touch a body push it by themselves: each counts for its share. */
  look({ ropes }: TiedGroup, dt: number): void {
    for (const rope of ropes) this.#look(rope, dt);
    for (const { strand, touched } of ropes)
      for (let i = 0; i < strand.points; i++)
        if (touched[i]! >= 0) strand.yields[i]! *= this.#bodies.counts[touched[i]!]!;
  }

  #look({ strand, settings, within, touched }: Rope, dt: number): void {
    const { radius, friction } = settings;
    const { points, holders, touches, places, free, frictions } = strand;
    touches.fill(0);
    touched.fill(-1);
    if (!(radius > 0)) return;
    for (let i = 0; i < points; i++) {
      if (holders[i] !== FREE) continue;
      let square = 0;
      for (let k = 0; k < 3; k++) {
        const way = dt * free[3 * i + k]!;
        from[k] = places[3 * i + k]!;
        to[k] = from[k]! + way;
        square += way * way;
      }
      const margin = AHEAD * radius + Math.sqrt(square);
      if (!this.#meets(radius, margin) || isWithin(within, i, met[MET.body]!)) continue;
      touches[i] = 1;
      touched[i] = met[MET.body]!;
      frictions[i] = friction;
      this.#note(strand, i, radius, dt);
    }
  }

  /** On its way, or near to it. */
  #meets(radius: number, margin: number): boolean {
    const obstacles = this.#obstacles;
    if (!obstacles.isNear(from, to, radius + margin)) return false;
    return (
      obstacles.meet(from, from, radius + margin, met, 1, 1) ||
      obstacles.meet(from, to, radius, met, 1, 1)
    );
  }

  #note(
    { normals, gaps, surfaces, yields }: Rope['strand'],
    i: number,
    radius: number,
    dt: number,
  ) {
    const bodies = this.#bodies;
    const slot = met[MET.body]!;
    for (let k = 0; k < 3; k++) {
      normals[3 * i + k] = met[MET.normal + k]!;
      point[k] = met[MET.point + k]!;
      to[k] = from[k]! - point[k]!;
    }
    // What begins inside comes out in time.
    gaps[i] = Math.max(dot3(to, 0, normals, 3 * i) - radius, -ROPE_RETURN * dt);
    bodies.add(slot);
    bodies.velocityAt(slot, point, surfaces, 3 * i);
    yields[i] = bodies.softness(slot, point, normals, 3 * i);
  }

  /** What is touched is pushed the other way, evenly through the step. */
  push({ ropes }: TiedGroup, dt: number): void {
    for (const { strand, touched } of ropes) {
      const { points, normals, presses, rubs, places, gaps } = strand;
      for (let i = 0; i < points; i++) {
        if (touched[i]! < 0 || !(presses[i]! > 0)) continue;
        for (let k = 0; k < 3; k++) {
          const j = 3 * i + k;
          force[k] = -(presses[i]! * normals[j]! + rubs[j]!) / dt;
          point[k] = places[j]! - gaps[i]! * normals[j]!;
        }
        this.#bodies.push(touched[i]!, point, force);
      }
    }
  }
}

function isWithin(within: Rope['within'], i: number, slot: number): boolean {
  for (const each of within)
    if (each.slot === slot && i >= each.first && i <= each.last) return true;
  return false;
}
