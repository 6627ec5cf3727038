import type { Body } from '../../dynamics/body.js';
import { applyInverseInertia } from '../../dynamics/inertia.js';
import type { Simulation } from '../../dynamics/simulation.js';
import { VELOCITY } from '../../engine/moving-bodies.js';
import { cross, dot, subtract } from '../../base/math.js';
import type { Vec3 } from '../../fields/types.js';
import { ROPE_RETURN } from '../../solver/tolerances.js';
import { FREE, type Strand } from '../../solver/ropes/strand.js';
import { MET, METS, Obstacles } from '../particles/collide/obstacles.js';
import type { Rope } from './rope.js';

/** How much farther than it goes in a step a point looks for something to touch, as a share of the radius of the rope. */
const AHEAD = 0.5;

const met = new Float64Array(METS);
const from = new Float64Array(3);
const to = new Float64Array(3);

const normalOf = (): Vec3 => [met[MET.normal]!, met[MET.normal + 1]!, met[MET.normal + 2]!];
const pointOf = (): Vec3 => [met[MET.point]!, met[MET.point + 1]!, met[MET.point + 2]!];

/** What points of ropes touch in a step, and what they do to it. */
export class RopeTouch {
  readonly #simulation: Simulation;
  readonly #obstacles: Obstacles;
  /** By slot: how many points touch it. */
  readonly #counts = new Map<number, number>();

  constructor(simulation: Simulation) {
    this.#simulation = simulation;
    this.#obstacles = new Obstacles(simulation);
  }

  /** Where bodies are when a step begins, however they came there. */
  take(dt: number): void {
    this.#obstacles.forget();
    this.#obstacles.take(dt);
    this.#counts.clear();
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

  /** Who each point of a rope may touch in a step that begins: `slots` has the bodies, -1 for none. */
  look(rope: Rope, slots: Int32Array, dt: number): void {
    const { strand, within } = rope;
    const { radius, friction } = rope.settings;
    const { points, holders, touches, places, free, frictions } = strand;
    for (let i = 0; i < points; i++) {
      touches[i] = 0;
      slots[i] = -1;
      if (holders[i] !== FREE || !(radius > 0)) continue;
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
      frictions[i] = friction;
      this.#note(strand, i, radius, slots, dt);
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

  #note(strand: Strand, i: number, radius: number, slots: Int32Array, dt: number): void {
    const { normals, gaps, surfaces, yields } = strand;
    const slot = met[MET.body]!;
    const normal = normalOf();
    const point = pointOf();
    const way: Vec3 = [from[0]! - point[0], from[1]! - point[1], from[2]! - point[2]];
    // What begins inside comes out in time.
    gaps[i] = Math.max(dot(way, normal) - radius, -ROPE_RETURN * dt);
    const body = this.#simulation.bodies.in(slot)!;
    const arm = subtract(point, body.centerOfMassWorld());
    const v = this.#simulation.bodies.velocities;
    const at = slot * VELOCITY;
    const turning = cross([v[at + 3]!, v[at + 4]!, v[at + 5]!], arm);
    for (let k = 0; k < 3; k++) {
      normals[3 * i + k] = normal[k]!;
      surfaces[3 * i + k] = v[at + k]! + turning[k]!;
    }
    yields[i] = isMoved(body) ? softness(body, arm, normal) : 0;
    slots[i] = slot;
    this.#counts.set(slot, (this.#counts.get(slot) ?? 0) + 1);
  }

  /** All that touch a body push it by themselves: each counts for its share of it. */
  share({ points, yields }: Strand, slots: Int32Array): void {
    for (let i = 0; i < points; i++) if (slots[i]! >= 0) yields[i]! *= this.#counts.get(slots[i]!)!;
  }

  /** What it touches is pushed the other way, evenly through the step. */
  push(
    { points, normals, presses, rubs, places, gaps }: Strand,
    slots: Int32Array,
    dt: number,
  ): void {
    const { scratch } = this.#simulation.engine;
    for (let i = 0; i < points; i++) {
      const body =
        slots[i]! >= 0 && presses[i]! > 0 ? this.#simulation.bodies.in(slots[i]!) : undefined;
      if (!body || !isMoved(body)) continue;
      const j = 3 * i;
      const force: Vec3 = [0, 0, 0];
      const point: Vec3 = [0, 0, 0];
      for (let k = 0; k < 3; k++) {
        force[k] = -(presses[i]! * normals[j + k]! + rubs[j + k]!) / dt;
        point[k] = places[j + k]! - gaps[i]! * normals[j + k]!;
      }
      const torque = cross(subtract(point, body.centerOfMassWorld()), force);
      body.body.applyCentralForce(scratch.vector(...force));
      body.body.applyTorque(scratch.vector(...torque));
    }
  }
}

const isWithin = (within: Rope['within'], i: number, slot: number): boolean =>
  within.some((each) => each.slot === slot && i >= each.first && i <= each.last);

const isMoved = (body: Body): boolean => body.isDynamic && !body.sleeping;

/** What a push of 1 N s along a direction does to the speed of a body along it, at the end of an arm: 1/kg. */
function softness(body: Body, arm: Vec3, direction: Vec3): number {
  const moment = cross(arm, direction);
  return 1 / body.mass.mass + dot(cross(applyInverseInertia(body, moment), arm), direction);
}
