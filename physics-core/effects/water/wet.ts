import type { Body } from '../../dynamics/body.js';
import type { Simulation } from '../../dynamics/simulation.js';
import type { Numbered } from '../effect/effect.js';
import { CALM } from './tolerances.js';
import type { WaterSource } from './volume.js';
import type { Wetting } from './wetting.js';

/** How a body lies in water: how deep, m, how fast it sinks, m/s, what it displaces, m³, and what that weighs, kg. */
type Lying = Pick<Wetting, 'deepest' | 'depth' | 'speed' | 'volume' | 'mass'>;

/** A wet body for a snapshot: its number, that of the water, whether it was free, and how it lies. */
export type KeptWet = [
  body: number,
  water: number,
  free: boolean,
  depth: number,
  speed: number,
  volume: number,
  mass: number,
];

/** A body that is in water, from step to step. */
export class WetBody {
  readonly body: Body;
  /** Nothing else was seen to act on it in the last step but its weight. */
  free = true;
  /** In this step of Bullet, and in any part of the world's step. */
  pushed = false;
  wetted = false;
  #told = false;
  readonly lying: Lying;

  constructor(body: Body, lying: Lying) {
    this.body = body;
    const { deepest, depth, speed, volume, mass } = lying;
    this.lying = { deepest, depth, speed, volume, mass };
  }

  /** As it does now: each body in each step, so nothing is made for that. */
  lie({ deepest, depth, speed, volume, mass }: Lying): void {
    const { lying } = this;
    lying.deepest = deepest;
    lying.depth = depth;
    lying.speed = speed;
    lying.volume = volume;
    lying.mass = mass;
  }

  static from(
    [id, of, free, depth, speed, volume, mass]: KeptWet,
    nodes: Numbered,
    sources: readonly WaterSource[],
  ): WetBody | undefined {
    const body = nodes.body(id);
    const deepest = sources.find((source) => source.id === of);
    if (!body || !deepest) return undefined;
    const wet = new WetBody(body, { deepest, depth, speed, volume, mass });
    wet.free = free;
    wet.#told = true;
    return wet;
  }

  get kept(): KeptWet {
    const { deepest, depth, speed, volume, mass } = this.lying;
    return [this.body.id, deepest.id, this.free, depth, speed, volume, mass];
  }

  enter(simulation: Simulation): void {
    if (this.#told) return;
    this.#told = true;
    this.#tell('waterenter', simulation);
  }

  leave(simulation: Simulation): void {
    if (this.#told) this.#tell('waterleave', simulation);
  }

  #tell(event: string, { time }: Simulation): void {
    const { deepest, depth, speed } = this.lying;
    this.body.emit(event, { water: deepest, depth, speed, time });
  }

  /** For people. */
  get known(): Record<string, unknown> {
    const { depth, volume, mass } = this.lying;
    return { depth, displaced: volume, carried: mass, why: this.#why };
  }

  get #why(): string {
    const { mass } = this.body.mass;
    const carried = this.lying.mass;
    if (Math.abs(carried - mass) <= CALM * mass)
      return 'it floats: what it displaces weighs as much as it does';
    return carried > mass
      ? 'it is lifted: what it displaces weighs more than it does'
      : 'it sinks or is held: what it displaces weighs less than it does';
  }
}
