import type { Simulation } from '../../dynamics/simulation.js';
import { CALM } from './tolerances.js';
import type { Volume, WaterSource } from './volume.js';
import type { Matter } from './matter.js';

/** How something lies in water: how deep, m, how fast it sinks, m/s, what it displaces, m³, and what that weighs, kg. */
export interface Lying {
  readonly deepest: Volume | undefined;
  readonly depth: number;
  readonly speed: number;
  readonly displaced: number;
  readonly mass: number;
}

/** One for a snapshot: its number, that of the water, and how it lies. */
export type KeptMatter = [
  id: number,
  water: number,
  depth: number,
  speed: number,
  displaced: number,
  mass: number,
  weighs: number,
];

/** What gives way and is in water, from step to step. */
export class WetMatter {
  readonly id: number;
  /** Undefined: it has not moved since the world went back. */
  matter: Matter | undefined;
  source: WaterSource;
  depth = 0;
  speed = 0;
  displaced = 0;
  mass = 0;
  /** kg, of its own. */
  weighs = 0;
  /** It was looked at in this step, and was in water. */
  met = false;
  wetted = false;
  #told = false;

  constructor(id: number, source: WaterSource) {
    this.id = id;
    this.source = source;
  }

  lie({ deepest, depth, speed, displaced, mass }: Lying, weighs: number): void {
    if (deepest) this.source = deepest.source;
    this.depth = depth;
    this.speed = speed;
    this.displaced = displaced;
    this.mass = mass;
    this.weighs = weighs;
  }

  static from(
    [id, of, depth, speed, displaced, mass, weighs]: KeptMatter,
    sources: readonly WaterSource[],
  ): WetMatter | undefined {
    const source = sources.find((each) => each.id === of);
    if (!source) return undefined;
    const wet = new WetMatter(id, source);
    wet.lie({ deepest: undefined, depth, speed, displaced, mass }, weighs);
    wet.#told = true;
    return wet;
  }

  get kept(): KeptMatter {
    const { id, source, depth, speed, displaced, mass, weighs } = this;
    return [id, source.id, depth, speed, displaced, mass, weighs];
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
    const { source, depth, speed } = this;
    this.matter?.emit(event, { water: source, depth, speed, time });
  }

  /** For people. */
  get known(): Record<string, unknown> {
    const { depth, displaced, mass } = this;
    return { depth, displaced, carried: mass, why: this.#why };
  }

  get #why(): string {
    if (Math.abs(this.mass - this.weighs) <= CALM * this.weighs)
      return 'it floats: what it displaces weighs as much as it does';
    return this.mass > this.weighs
      ? 'it is lifted: what it displaces weighs more than it does'
      : 'it sinks or is held: what it displaces weighs less than it does';
  }
}
