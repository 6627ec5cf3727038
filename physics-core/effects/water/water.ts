import { isHeld } from '../../dynamics/jointed.js';
import { lengthOf } from '../../base/exact/index.js';
import { grown } from '../../base/grown.js';
import type { Body } from '../../dynamics/body.js';
import type { Simulation } from '../../dynamics/simulation.js';
import { SAME } from '../../engine/free-fall.js';
import { VELOCITY } from '../../engine/moving-bodies.js';
import type { Vec3 } from '../../fields/types.js';
import { Effect, type Cause, type Numbered } from '../effect/effect.js';
import type { Effects } from '../effect/effects.js';
import { carrying } from '../drag/effects.js';
import { flight } from '../flight/flight.js';
import { BodyInWater } from './body-in-water.js';
import { waves } from './effects.js';
import { WaterPush } from './push.js';
import type { KeptMatter } from './wet-matter.js';
import type { Matter, Points, WetLine, WetSurface } from './matter.js';
import type { Swimmer } from './swimmer.js';
import type { Swimming } from './swimming.js';
import { swimming } from './effects.js';
import { soak, type Drops } from './soak.js';
import { volumesOf, type SurfaceMet, type Volume, type WaterSource } from './volume.js';
import { WetBody, type KeptWet } from './wet.js';

/** For a snapshot: bodies, and what gives way where there is such. */
type Kept = KeptWet[] | { bodies: KeptWet[]; matter: KeptMatter[] };

const now = new Float64Array(VELOCITY);

/** Bodies float. */
export class Water extends Effect {
  readonly #simulation: Simulation;
  readonly #effects: Effects;
  readonly #push: WaterPush;
  #volumes: readonly Volume[] | undefined;
  /** By slot. */
  readonly #shapes: (BodyInWater | undefined)[] = [];
  readonly #wet = new Map<Body, WetBody>();
  /** Of what gives way; undefined: there is nothing such in the world. */
  #matter: Swimming | undefined;
  /** By slot: what a body gains in the step if nothing else acts on it, m/s. */
  #gains = new Float64Array(16 * 3);

  constructor(simulation: Simulation, effects: Effects) {
    super();
    this.#simulation = simulation;
    this.#effects = effects;
    this.#push = new WaterPush(simulation);
  }

  override need(source: WaterSource, reason: string): void {
    super.need(source, reason);
    this.changed();
  }

  override release(node: Cause): void {
    if (!this.isNeededBy(node)) return;
    super.release(node);
    this.changed();
    // Without any water no step looks at them again.
    if (!this.active) this.#dry();
  }

  #dry(): void {
    for (const wet of this.#wet.values()) wet.leave(this.#simulation);
    this.#wet.clear();
    this.#matter?.dry();
  }

  override unmade(node: Cause): void {
    this.#wet.delete(node as Body);
    super.unmade(node);
  }

  /** An author said something about a volume: what rested in it floats otherwise, and so does what it comes to. */
  changed(): void {
    this.#volumes = undefined;
    const { bodies } = this.#simulation;
    const { slots, pointers, asleep } = bodies.moving;
    for (let slot = 0; slot < slots; slot++) {
      const body = pointers[slot] !== 0 && asleep[slot] === 1 ? bodies.in(slot) : undefined;
      if (body && (this.#wet.has(body) || this.#reaches(body))) body.wake();
    }
    this.#effects.waterChanged();
  }

  #reaches(body: Body): boolean {
    const centre = body.centerOfMassWorld();
    return this.#here.some((volume) => volume.reaches(centre, body.reach));
  }

  get #here(): readonly Volume[] {
    if (this.#volumes) return this.#volumes;
    const volumes = volumesOf(this.inOrder as readonly WaterSource[]);
    const moving = this.#effects.caused(waves);
    for (const volume of volumes) volume.waves = moving?.of(volume.source);
    return (this.#volumes = volumes);
  }

  // ---- a step -----------------------------------------------------------------------------------------------------

  override beforeStep(dt: number): void {
    const volumes = this.#here;
    const { bodies } = this.#simulation;
    const { slots, pointers, asleep } = bodies.moving;
    if (this.#gains.length < 3 * slots) this.#gains = grown(this.#gains, 6 * slots);
    for (const wet of this.#wet.values()) wet.pushed = false;
    for (let slot = 0; slot < slots; slot++) {
      const body = pointers[slot] !== 0 && asleep[slot] === 0 ? bodies.in(slot) : undefined;
      if (body) this.#pushBody(body, volumes, dt);
    }
    if (volumes.some(({ waves }) => waves)) this.#stir(volumes, dt);
  }

  /** What is carried through surfaces that move stirs them, and goes its own way. */
  #stir(volumes: readonly Volume[], dt: number): void {
    const causes = this.#effects.caused(carrying)?.causes;
    if (!causes) return;
    for (const body of ([...causes] as Body[]).sort((a, b) => a.id - b.id))
      if (!body.movable) this.#reckon(body, volumes, dt, false);
  }

  /** False: it is in no water. */
  #reckon(body: Body, volumes: readonly Volume[], dt: number, free: boolean): boolean {
    const push = this.#push;
    for (const { waves } of volumes) waves?.attend(body);
    const pushed = push.reckon(body, this.#shapeOf(body), volumes, dt, free);
    for (const { waves } of volumes) waves?.answer(push.force, push.wetting.volume, dt);
    return pushed;
  }

  #pushBody(body: Body, volumes: readonly Volume[], dt: number): void {
    const known = this.#wet.get(body);
    const free = !isHeld(body) && (known?.free ?? true);
    if (!this.#reckon(body, volumes, dt, free)) return;
    const { force, torque, gain, wetting } = this.#push;
    const { scratch } = this.#simulation.engine;
    body.body.applyCentralForce(scratch.vector(force[0]!, force[1]!, force[2]!));
    body.body.applyTorque(scratch.vector(torque[0]!, torque[1]!, torque[2]!));
    this.#gains.set(gain, 3 * body.slot);
    if (free || wetting.stiffness > 0) this.#effects.caused(flight)?.vary(body);
    const wet = known ?? new WetBody(body, wetting);
    wet.lie(wetting);
    wet.free = free;
    wet.pushed = wet.wetted = true;
    this.#wet.set(body, wet);
  }

  #shapeOf(body: Body): BodyInWater {
    const known = this.#shapes[body.slot];
    if (known?.isOf(body)) return known;
    return (this.#shapes[body.slot] = new BodyInWater(body));
  }

  /** What is free goes on with the mean of the speeds at both ends of the step. */
  override settle(dt: number): void {
    for (const wet of this.#wet.values()) {
      if (!wet.pushed || isHeld(wet.body)) continue;
      const free = this.#isFree(wet.body, dt);
      if (wet.free && free) this.#place(wet.body, dt);
      wet.free = free;
    }
  }

  /** Whether its velocity, read into `now`, is what its weight and the water made of it, each as large as the other. */
  #isFree({ pointer, slot, dampedShare, appliedGravity }: Body, dt: number): boolean {
    const { engine, bodies } = this.#simulation;
    const left = (1 - dampedShare.linear) ** dt;
    const fall = lengthOf(appliedGravity) * dt;
    engine.reader.velocity(pointer, now, 0);
    for (let k = 0; k < 3; k++) {
      const before = bodies.velocities[slot * VELOCITY + k]! * left;
      const gain = this.#gains[3 * slot + k]!;
      const most = SAME * (fall + Math.abs(before) + Math.abs(gain));
      if (Math.abs(now[k]! - before - gain) > most) return false;
    }
    return true;
  }

  /** Bullet took it there by the speed at the end. */
  #place({ pointer, slot }: Body, dt: number): void {
    const { engine, bodies } = this.#simulation;
    const v = bodies.velocities;
    const at = slot * VELOCITY;
    const half = -dt / 2;
    engine.reader.shift(
      pointer,
      half * (now[0]! - v[at]!),
      half * (now[1]! - v[at + 1]!),
      half * (now[2]! - v[at + 2]!),
    );
  }

  override stepOver(): void {
    for (const wet of this.#wet.values()) {
      if (wet.wetted) wet.enter(this.#simulation);
      // What sleeps is where it was.
      else if (!wet.body.sleeping) {
        this.#wet.delete(wet.body);
        wet.leave(this.#simulation);
      }
      wet.wetted = false;
    }
    this.#matter?.stepOver();
  }

  /** Nodes that give way wait for its code where there is water, and the other way round. */
  get #swimming(): Swimming {
    return (this.#matter ??= swimming.code.swimming(this.#simulation));
  }

  /** A step of `dt` seconds begins for a cloth or a soft body: undefined, where no water is near it. */
  swim(matter: Matter & WetSurface, dt: number): Swimmer<WetSurface> | undefined {
    return this.#swimming.surface(matter, this.#here, dt);
  }

  /** The same of a rope. */
  swimLine(matter: Matter & WetLine, dt: number): Swimmer<WetLine> | undefined {
    return this.#swimming.line(matter, this.#here, dt);
  }

  /** Whether one that rests has to do with water. */
  concerns(matter: Matter, points: Points): boolean {
    return this.#swimming.concerns(matter, points, this.#here);
  }

  /** Whether the surface moves that it rests on. */
  isRocked(id: number): boolean {
    return this.#matter?.isRocked(id, this.#here) === true;
  }

  /** Something that gives way is there no more. */
  forget(id: number): void {
    this.#matter?.forget(id);
  }

  /** After a step of `dt` seconds of particles in it. */
  soak(drops: Drops, dt: number): void {
    soak(drops, this.#here, dt);
  }

  // ---- looking in -------------------------------------------------------------------------------------------------

  /** What water did to a body in its last step, as plain data; undefined: it is in none. */
  known(body: Body): Record<string, unknown> | undefined {
    return this.#wet.get(body)?.known;
  }

  /** The same of what gives way, by its number. */
  knownOfMatter(id: number): Record<string, unknown> | undefined {
    return this.#matter?.known(id);
  }

  /** How many bodies are in a volume, and what they displace, m³. */
  knownOf(source: WaterSource): Record<string, unknown> {
    const lying = [...this.#wet.values()].map((wet) => wet.lying);
    const within = lying.filter(({ deepest }) => deepest === source);
    const soft = this.#matter?.within(source) ?? [];
    let displaced = within.reduce((sum, { volume }) => sum + volume, 0);
    for (const each of soft) displaced += each.displaced;
    return { bodies: within.length, softBodies: soft.length, displaced };
  }

  /** The first surface on the way between two points of the world. */
  meets(from: Vec3, to: Vec3): SurfaceMet | undefined {
    let first: SurfaceMet | undefined;
    for (const volume of this.#here) {
      const met = volume.meets(from, to);
      if (met && !(met.fraction >= (first?.fraction ?? Infinity))) first = met;
    }
    return first;
  }

  // ---- going back -------------------------------------------------------------------------------------------------

  override reset(): void {
    this.#wet.clear();
    this.#matter?.clear();
  }

  override save(): Kept | undefined {
    const matter = this.#matter?.kept ?? [];
    if (this.#wet.size === 0 && matter.length === 0) return undefined;
    const bodies = [...this.#wet.values()].map(({ kept }) => kept);
    return matter.length > 0 ? { bodies, matter } : bodies;
  }

  override load(saved: Kept, nodes: Numbered): void {
    const { bodies, matter } = Array.isArray(saved) ? { bodies: saved, matter: [] } : saved;
    if (matter.length > 0) this.#swimming.load(matter, this.inOrder as readonly WaterSource[]);
    for (const kept of bodies) {
      const wet = WetBody.from(kept, nodes, this.inOrder as readonly WaterSource[]);
      if (wet) this.#wet.set(wet.body, wet);
    }
  }
}
