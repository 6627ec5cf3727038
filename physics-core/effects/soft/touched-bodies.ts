import { grown, grownInt } from '../../base/grown.js';
import { MATRIX } from '../../base/matrix.js';
import type { Body } from '../../dynamics/body.js';
import { inverseInertiaOf } from '../../dynamics/inertia.js';
import type { Simulation } from '../../dynamics/simulation.js';
import { VELOCITY } from '../../engine/moving-bodies.js';

const moment = new Float64Array(3);
const spin = new Float64Array(3);
const arm = new Float64Array(3);

const isMoved = (body: Body): boolean => body.isDynamic && !body.sleeping;

/** The bodies that points of ropes touch in a step, by slot: what is to be known of each is read once. */
export class TouchedBodies {
  readonly #simulation: Simulation;
  #known = new Uint8Array(0);
  /** How many points touch each, and whether that moves it. */
  counts = new Int32Array(0);
  #moved = new Uint8Array(0);
  #centres = new Float64Array(0);
  /** Of the world's axes, a column each: what a moment about it does to the spin. */
  #inertias = new Float64Array(0);
  #inverseMasses = new Float64Array(0);

  constructor(simulation: Simulation) {
    this.#simulation = simulation;
  }

  begin(): void {
    const { slots } = this.#simulation.bodies.moving;
    this.counts.fill(0);
    this.#known.fill(0);
    if (this.counts.length >= slots) return;
    this.counts = grownInt(this.counts, 2 * slots);
    this.#known = new Uint8Array(2 * slots);
    this.#moved = new Uint8Array(2 * slots);
    this.#centres = grown(this.#centres, 6 * slots);
    this.#inertias = grown(this.#inertias, 2 * MATRIX * slots);
    this.#inverseMasses = grown(this.#inverseMasses, 2 * slots);
  }

  /** One more spot touches it. */
  add(slot: number): void {
    this.counts[slot]!++;
    this.know(slot);
  }

  /** Where it is and how it moves is to be asked. */
  know(slot: number): void {
    if (this.#known[slot]) return;
    this.#known[slot] = 1;
    const body = this.#simulation.bodies.in(slot)!;
    this.#centres.set(body.centerOfMassWorld(), 3 * slot);
    this.#moved[slot] = isMoved(body) ? 1 : 0;
    if (!this.#moved[slot]) return;
    this.#inverseMasses[slot] = 1 / body.mass.mass;
    this.#inertias.set(inverseInertiaOf(body), MATRIX * slot);
  }

  /** How fast a point of it goes, m/s. */
  velocityAt(slot: number, point: Float64Array, out: Float64Array, at: number): void {
    const v = this.#simulation.bodies.velocities;
    const n = slot * VELOCITY;
    this.#armTo(slot, point);
    out[at] = v[n]! + v[n + 4]! * arm[2]! - v[n + 5]! * arm[1]!;
    out[at + 1] = v[n + 1]! + v[n + 5]! * arm[0]! - v[n + 3]! * arm[2]!;
    out[at + 2] = v[n + 2]! + v[n + 3]! * arm[1]! - v[n + 4]! * arm[0]!;
  }

  /** What a push of 1 N s along a direction does to the speed of a point of it along that: 1/kg. */
  softness(slot: number, point: Float64Array, direction: Float64Array, at: number): number {
    if (!this.#moved[slot]) return 0;
    this.#armTo(slot, point);
    this.#momentOf(direction, at);
    const m = this.#inertias;
    const n = MATRIX * slot;
    for (let k = 0; k < 3; k++)
      spin[k] = m[n + k]! * moment[0]! + m[n + 3 + k]! * moment[1]! + m[n + 6 + k]! * moment[2]!;
    let sum = this.#inverseMasses[slot]!;
    for (let k = 0; k < 3; k++) sum += spin[k]! * moment[k]!;
    return sum;
  }

  /** A force at a point of it, newtons, through the step. */
  push(slot: number, point: Float64Array, force: Float64Array): void {
    if (!this.#moved[slot]) return;
    const { scratch } = this.#simulation.engine;
    const { body } = this.#simulation.bodies.in(slot)!;
    this.#armTo(slot, point);
    this.#momentOf(force, 0);
    body.applyCentralForce(scratch.vector(force[0]!, force[1]!, force[2]!));
    body.applyTorque(scratch.vector(moment[0]!, moment[1]!, moment[2]!));
  }

  #armTo(slot: number, point: Float64Array): void {
    for (let k = 0; k < 3; k++) arm[k] = point[k]! - this.#centres[3 * slot + k]!;
  }

  #momentOf(direction: Float64Array, at: number): void {
    const x = direction[at]!;
    const y = direction[at + 1]!;
    const z = direction[at + 2]!;
    moment[0] = arm[1]! * z - arm[2]! * y;
    moment[1] = arm[2]! * x - arm[0]! * z;
    moment[2] = arm[0]! * y - arm[1]! * x;
  }
}
