import type { Simulation } from '../../dynamics/simulation.js';
import { Effect, type Cause } from '../effect/effect.js';
import type { Effects } from '../effect/effects.js';
import { Bounces } from './bounces.js';
import { MOST_PARTICLES } from './budget.js';
import { Obstacles } from './collide/obstacles.js';
import { hear, Told } from './elsewhere.js';
import { Pushed } from './pushed.js';
import { ParticleSystem, type KeptSystem } from './particle-system.js';
import { seenIn, type CloudPicture } from './seen.js';
import type { Settings } from './settings.js';
import type { Wind } from './wind.js';
import { water } from '../water/effects.js';
import { WindOnBodies } from './wind-on-bodies.js';

/** A node that has a system of particles. */
export interface ParticleSource extends Cause {
  readonly id: number;
  readonly settings: Settings;
  /** After each step: whether it has particles, or will have some by itself; and whether the world has no room for more. */
  stepped(active: boolean, crowded: boolean): void;
  /** It is told anew whether it is active, whatever was told where it comes from. */
  tellAnew(): void;
}

const NOTHING: CloudPicture = { motion: new Float32Array(0), ages: new Float32Array(0) };

/** All particle systems of a world. */
export class Particles extends Effect {
  readonly #simulation: Simulation;
  readonly #effects: Effects;
  /** By the numbers of their nodes. */
  readonly #systems = new Map<number, ParticleSystem>();
  readonly #obstacles: Obstacles;
  readonly #pushed: Pushed;
  readonly #bounces: Bounces;
  readonly #told = new Told();
  readonly #windOnBodies: WindOnBodies;
  /** That push bodies in this step. */
  readonly #winds: Wind[] = [];

  constructor(simulation: Simulation, effects: Effects) {
    super();
    this.#simulation = simulation;
    this.#effects = effects;
    this.#obstacles = new Obstacles(simulation);
    this.#pushed = new Pushed(simulation, effects);
    this.#bounces = new Bounces(this.#obstacles, this.#pushed);
    this.#windOnBodies = new WindOnBodies(simulation);
  }

  /** The system of a node that needs it. */
  of({ id }: ParticleSource): ParticleSystem | undefined {
    return this.#systems.get(id);
  }

  get #sources(): readonly ParticleSource[] {
    return this.inOrder as readonly ParticleSource[];
  }

  override need(source: ParticleSource, reason: string): void {
    if (!this.of(source)) this.#systems.set(source.id, this.#make(source));
    super.need(source, reason);
    this.changed();
  }

  #make(source: ParticleSource): ParticleSystem {
    return new ParticleSystem(this.#simulation, this.#bounces, () => source.settings);
  }

  override release(node: Cause): void {
    const source = node as ParticleSource;
    // What leaned against its wind falls.
    if (this.of(source)?.blows) this.#windOnBodies.wake();
    this.#systems.delete(source.id);
    super.release(node);
  }

  /** An author said something about a system, or about what emits or moves its particles. */
  changed(): void {
    for (const system of this.#systems.values()) system.stale = true;
    this.#simulation.bodies.goOn();
  }

  /** Winds push bodies, as any force of the step does. */
  override beforeStep(dt: number): void {
    const { timeStep } = this.#simulation;
    this.#winds.length = 0;
    let change = false;
    for (const source of this.#sources) {
      const system = this.of(source)!;
      if (system.windsChange()) change = true;
      for (const wind of system.windsIn(timeStep)) this.#winds.push(wind);
    }
    if (change) this.#windOnBodies.wake();
    if (this.#winds.length > 0) this.#windOnBodies.blow(this.#winds, dt);
  }

  override settle(dt: number): void {
    this.#windOnBodies.settle(this.#winds, dt);
  }

  /** Bodies have gone their whole way by then, in however many parts. */
  override stepOver(dt: number): void {
    if (this.#anyCollides()) this.#obstacles.take(dt);
    else this.#obstacles.forget();
    let goesOn = false;
    const sea = this.#effects.caused(water);
    let room = MOST_PARTICLES - this.#living;
    for (const source of this.#sources) {
      const system = this.of(source)!;
      room += system.cloud.count;
      system.step(dt, room);
      system.soak(sea, dt);
      room -= system.cloud.count;
      const { active, crowded } = system;
      if (active) goesOn = true;
      source.stepped(active, crowded);
    }
    this.#pushed.end();
    if (goesOn) this.#simulation.bodies.goOn();
  }

  get #living(): number {
    let living = 0;
    for (const { cloud } of this.#systems.values()) living += cloud.count;
    return living;
  }

  #anyCollides(): boolean {
    for (const system of this.#systems.values()) if (system.collides) return true;
    return false;
  }

  // ---- what is seen -----------------------------------------------------------------------------------------------

  /** Steps are taken here from now on, of a world of which nobody knows here what it told. */
  tellAnew(): void {
    for (const source of this.#sources) source.tellAnew();
  }

  /** What a page is to hear whose steps are taken here. */
  tell(room: Float64Array<ArrayBuffer>): Float64Array<ArrayBuffer> {
    return this.#told.write(this.#systems, room);
  }

  /** Its steps are taken elsewhere; what that side told. */
  hear(told: Float64Array): void {
    if (told[0] !== 0) hear(this.#systems, told);
  }

  get pictures(): [id: number, picture: CloudPicture][] {
    return [...this.#systems].map(([id, { picture }]) => [id, picture]);
  }

  /** Somebody looks back at these; undefined: not any more. What had no particles then has none. */
  lookBack(pictures: ReadonlyMap<number, CloudPicture> | undefined): void {
    for (const [id, system] of this.#systems)
      system.lookBack(pictures && seenIn(pictures.get(id) ?? NOTHING));
  }

  // ---- going back -------------------------------------------------------------------------------------------------

  override reset(): void {
    for (const system of this.#systems.values()) system.reset();
    this.#obstacles.forget();
  }

  override save(): [id: number, kept: KeptSystem][] {
    return [...this.#systems].map(([id, system]) => [id, system.save()]);
  }

  override load(saved: readonly [id: number, kept: KeptSystem][]): void {
    for (const [id, kept] of saved) this.#systems.get(id)?.load(kept);
    if (saved.some(([, { met }]) => met)) this.#obstacles.goOn();
    this.#simulation.bodies.goOn();
  }
}
