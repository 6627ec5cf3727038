import { dot3 } from '../../base/flat-math.js';
import { MATRIX } from '../../base/matrix.js';
import { doublesOf, pack } from '../../base/packed.js';
import type { Body } from '../../dynamics/body.js';
import { inverseInertiaOf } from '../../dynamics/inertia.js';
import type { Simulation } from '../../dynamics/simulation.js';
import { VELOCITY } from '../../engine/moving-bodies.js';
import { UNFELT, WAKES } from './tolerances.js';

/** Numbers of one: linear, then angular. */
const SIX = 6;

const arm = new Float64Array(3);
const moment = new Float64Array(3);
const spin = new Float64Array(3);
const load = new Float64Array(SIX);
const force = new Float64Array(3);

/** What is known of bodies from the step before, for a snapshot. */
export type KeptGuests = [id: number, state: string][];

/**
 * Bodies that cloth and soft bodies touch or are tied to, as they go through the parts of a step: by themselves, and by what
 * pushes them there. What that gives them in all they get as a force through the step, so that no momentum is lost. Who
 * stands on something does not go where its weight would take it: as much of what pushed it in the last step as did not move
 * it then is borne in this one, too.
 */
export class Guests {
  readonly #simulation: Simulation;
  #slots: number[] = [];
  /** By slot. */
  #here = new Uint8Array(0);
  #moved = new Uint8Array(0);
  #centres = new Float64Array(0);
  #inertias = new Float64Array(0);
  #inverseMasses = new Float64Array(0);
  /** m/s and rad/s; what these change by in a second; how far that has gone, and had gone when the part began. */
  #velocities = new Float64Array(0);
  #accelerations = new Float64Array(0);
  #ways = new Float64Array(0);
  #waysBefore = new Float64Array(0);
  /** N s and N m s. */
  #impulses = new Float64Array(0);
  /** Of the step before: its number, its velocity then, and what pushed it, m/s². */
  readonly #last = new Map<number, Float64Array>();
  readonly #ids = new Set<number>();

  constructor(simulation: Simulation) {
    this.#simulation = simulation;
  }

  begin(): void {
    const { slots } = this.#simulation.bodies.moving;
    for (const slot of this.#slots) this.#here[slot] = 0;
    this.#slots.length = 0;
    if (this.#here.length >= slots) return;
    const room = 2 * slots;
    this.#here = new Uint8Array(room);
    this.#moved = new Uint8Array(room);
    this.#centres = new Float64Array(3 * room);
    this.#inertias = new Float64Array(MATRIX * room);
    this.#inverseMasses = new Float64Array(room);
    this.#velocities = new Float64Array(SIX * room);
    this.#accelerations = new Float64Array(SIX * room);
    this.#ways = new Float64Array(SIX * room);
    this.#waysBefore = new Float64Array(SIX * room);
    this.#impulses = new Float64Array(SIX * room);
  }

  /** It takes part in the step that begins, of `dt` seconds. */
  add(slot: number, dt: number): void {
    if (this.#here[slot] === 1) return;
    this.#here[slot] = 1;
    this.#slots.push(slot);
    const body = this.#simulation.bodies.in(slot)!;
    const at = SIX * slot;
    this.#centres.set(body.centerOfMassWorld(), 3 * slot);
    this.#ways.fill(0, at, at + SIX);
    this.#waysBefore.fill(0, at, at + SIX);
    this.#impulses.fill(0, at, at + SIX);
    this.#accelerations.fill(0, at, at + SIX);
    const { velocities } = this.#simulation.bodies;
    for (let k = 0; k < SIX; k++)
      this.#velocities[at + k] = body.sleeping ? 0 : velocities[VELOCITY * slot + k]!;
    this.#moved[slot] = body.isDynamic && !body.sleeping ? 1 : 0;
    this.#inverseMasses[slot] = 0;
    if (this.#moved[slot] === 1) this.#free(body, slot, dt);
  }

  #free(body: Body, slot: number, dt: number): void {
    const at = SIX * slot;
    this.#inverseMasses[slot] = 1 / body.mass.mass;
    this.#inertias.set(inverseInertiaOf(body), MATRIX * slot);
    this.#simulation.engine.reader.load(body.pointer, load, 0);
    for (let k = 0; k < 3; k++)
      this.#accelerations[at + k] = body.appliedGravity[k]! + load[k]! / body.mass.mass;
    for (let k = 0; k < 3; k++) moment[k] = load[3 + k]!;
    this.#turn(slot);
    for (let k = 0; k < 3; k++) this.#accelerations[at + 3 + k] = spin[k]!;
    const share = this.#freedom(body, slot, dt);
    this.#inverseMasses[slot]! *= share;
    for (let n = MATRIX * slot; n < MATRIX * (slot + 1); n++) this.#inertias[n]! *= share;
    for (let k = 0; k < SIX; k++) this.#accelerations[at + k]! *= share;
  }

  /** Which share of what pushed it in the last step moved it: all of it, unless something else acted against that. */
  #freedom(body: Body, slot: number, dt: number): number {
    const last = this.#last.get(body.id);
    if (!last) return 1;
    let against = 0;
    let square = 0;
    let other = 0;
    for (let k = 0; k < 3; k++) {
      const pushed = last[3 + k]!;
      const rest = (this.#velocities[SIX * slot + k]! - last[k]!) / dt - pushed;
      against -= rest * pushed;
      other += rest * rest;
      square += pushed * pushed;
    }
    const weight = dot3(this.#accelerations, SIX * slot, this.#accelerations, SIX * slot);
    if (other <= UNFELT ** 2 * weight || square === 0) return 1;
    return 1 - Math.min(1, Math.max(0, against / square));
  }

  /** Goes on by a part of the step. */
  go(time: number): void {
    for (const slot of this.#slots)
      for (let n = SIX * slot; n < SIX * slot + SIX; n++) {
        this.#waysBefore[n] = this.#ways[n]!;
        this.#velocities[n]! += time * this.#accelerations[n]!;
        this.#ways[n]! += time * this.#velocities[n]!;
      }
  }

  /** How far a point of it has gone since the step began, and of that in this part. */
  wayOf(slot: number, point: Float64Array, at: number, out: Float64Array): void {
    this.#armTo(slot, point, at);
    const ways = this.#ways;
    const n = SIX * slot;
    out[0] = ways[n]! + ways[n + 4]! * arm[2]! - ways[n + 5]! * arm[1]!;
    out[1] = ways[n + 1]! + ways[n + 5]! * arm[0]! - ways[n + 3]! * arm[2]!;
    out[2] = ways[n + 2]! + ways[n + 3]! * arm[1]! - ways[n + 4]! * arm[0]!;
    const were = this.#waysBefore;
    const u = ways[n + 3]! - were[n + 3]!;
    const v = ways[n + 4]! - were[n + 4]!;
    const w = ways[n + 5]! - were[n + 5]!;
    out[3] = ways[n]! - were[n]! + v * arm[2]! - w * arm[1]!;
    out[4] = ways[n + 1]! - were[n + 1]! + w * arm[0]! - u * arm[2]!;
    out[5] = ways[n + 2]! - were[n + 2]! + u * arm[1]! - v * arm[0]!;
  }

  /** How much a point of it gives way to a push along a direction, 1/kg. */
  gives(slot: number, point: Float64Array, at: number, way: Float64Array): number {
    if (this.#moved[slot] === 0) return 0;
    this.#armTo(slot, point, at);
    this.#momentOf(way, 0);
    this.#turn(slot);
    return this.#inverseMasses[slot]! * dot3(way, 0, way, 0) + dot3(spin, 0, moment, 0);
  }

  /** A point of it is moved by a push, kg m, in a part of `time` seconds. */
  push(slot: number, point: Float64Array, at: number, push: Float64Array, time: number): void {
    this.#armTo(slot, point, at);
    this.#momentOf(push, 0);
    const n = SIX * slot;
    for (let k = 0; k < 3; k++) {
      this.#impulses[n + k]! += push[k]! / time;
      this.#impulses[n + 3 + k]! += moment[k]! / time;
    }
    if (this.#moved[slot] === 0) return;
    this.#turn(slot);
    for (let k = 0; k < 3; k++) {
      const way = this.#inverseMasses[slot]! * push[k]!;
      this.#ways[n + k]! += way;
      this.#velocities[n + k]! += way / time;
      this.#ways[n + 3 + k]! += spin[k]!;
      this.#velocities[n + 3 + k]! += spin[k]! / time;
    }
  }

  /** What they got in all goes to them, evenly through a step of `dt` seconds; who sleeps wakes of it, where it may. */
  end(dt: number, wakes: (slot: number) => boolean): void {
    const { scratch } = this.#simulation.engine;
    this.#forgetOthers();
    for (const slot of this.#slots) {
      const node = this.#simulation.bodies.in(slot)!;
      if (!node.isDynamic) continue;
      if (node.sleeping && wakes(slot) && this.#disturbs(node, slot, dt)) node.wake();
      const n = SIX * slot;
      // What lost its numbers pushes nothing.
      if (node.sleeping || !this.#isFinite(n)) {
        this.#last.delete(node.id);
        continue;
      }
      const { reader } = this.#simulation.engine;
      reader.load(node.pointer, load, 0);
      const last = this.#last.get(node.id) ?? new Float64Array(SIX);
      for (let k = 0; k < 3; k++) {
        last[k] = this.#simulation.bodies.velocities[VELOCITY * slot + k]!;
        last[3 + k] =
          node.appliedGravity[k]! + (load[k]! + this.#impulses[n + k]! / dt) / node.mass.mass;
      }
      this.#last.set(node.id, last);
      for (let k = 0; k < 3; k++) {
        force[k] = this.#impulses[n + k]! / dt;
        moment[k] = this.#impulses[n + 3 + k]! / dt;
      }
      node.body.applyCentralForce(scratch.vector(force[0]!, force[1]!, force[2]!));
      node.body.applyTorque(scratch.vector(moment[0]!, moment[1]!, moment[2]!));
    }
  }

  /** Of who takes no part in this step nothing is known in the next. */
  #forgetOthers(): void {
    this.#ids.clear();
    for (const slot of this.#slots) this.#ids.add(this.#simulation.bodies.in(slot)!.id);
    for (const id of this.#last.keys()) if (!this.#ids.has(id)) this.#last.delete(id);
  }

  #isFinite(n: number): boolean {
    let sum = 0;
    for (let k = 0; k < SIX; k++) sum += this.#impulses[n + k]!;
    return Number.isFinite(sum);
  }

  /** Whether what pushes a body that sleeps is more than nothing beside its weight. */
  #disturbs({ appliedGravity, mass }: Body, slot: number, dt: number): boolean {
    const n = SIX * slot;
    const weight = mass.mass * dt * Math.sqrt(appliedGravity.reduce((sum, g) => sum + g * g, 0));
    const pushed = Math.sqrt(dot3(this.#impulses, n, this.#impulses, n));
    return pushed > WAKES * weight;
  }

  forget(): void {
    this.#last.clear();
  }

  save(): KeptGuests {
    return [...this.#last].map(([id, state]) => [id, pack(state)]);
  }

  load(kept: KeptGuests): void {
    this.#last.clear();
    for (const [id, state] of kept) this.#last.set(id, doublesOf(state));
  }

  #armTo(slot: number, point: Float64Array, at: number): void {
    for (let k = 0; k < 3; k++) arm[k] = point[at + k]! - this.#centres[3 * slot + k]!;
  }

  #momentOf(way: Float64Array, at: number): void {
    const x = way[at]!;
    const y = way[at + 1]!;
    const z = way[at + 2]!;
    moment[0] = arm[1]! * z - arm[2]! * y;
    moment[1] = arm[2]! * x - arm[0]! * z;
    moment[2] = arm[0]! * y - arm[1]! * x;
  }

  /** What `moment` does to its spin. */
  #turn(slot: number): void {
    const m = this.#inertias;
    const n = MATRIX * slot;
    for (let k = 0; k < 3; k++)
      spin[k] = m[n + k]! * moment[0]! + m[n + 3 + k]! * moment[1]! + m[n + 6 + k]! * moment[2]!;
  }
}
