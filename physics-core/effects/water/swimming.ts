import type { Simulation } from '../../dynamics/simulation.js';
import { lengthOf } from '../../base/exact/index.js';
import type { Volume, WaterSource } from './volume.js';
import type { Matter, Points, WetLine, WetSurface } from './matter.js';
import { SoakedLine } from './soaked-line.js';
import { SoakedSurface } from './soaked-surface.js';
import { Swimmer, type Soaked } from './swimmer.js';
import { WetMatter, type KeptMatter } from './wet-matter.js';

const middle = new Float64Array(3);
const way = new Float64Array(3);

const soakedSurface = (): SoakedSurface => new SoakedSurface();
const soakedLine = (): SoakedLine => new SoakedLine();

/** All that gives way and is in water, by the numbers of their nodes. */
export class Swimming {
  readonly #simulation: Simulation;
  readonly #all = new Map<number, WetMatter>();
  readonly #swimmers = new Map<number, Swimmer>();

  constructor(simulation: Simulation) {
    this.#simulation = simulation;
  }

  /** A step of `dt` seconds begins for a cloth or a soft body that moves: undefined, where there is no water near it. */
  surface(
    of: Matter & WetSurface,
    volumes: readonly Volume[],
    dt: number,
  ): Swimmer<WetSurface> | undefined {
    return this.#swim(of, of.masses, soakedSurface, volumes, dt);
  }

  /** The same of a rope. */
  line(of: Matter & WetLine, volumes: readonly Volume[], dt: number): Swimmer<WetLine> | undefined {
    return this.#swim(of, of.points, soakedLine, volumes, dt);
  }

  #swim<Kind>(
    of: Matter & Kind,
    points: Points,
    soaked: () => Soaked<Kind>,
    volumes: readonly Volume[],
    dt: number,
  ): Swimmer<Kind> | undefined {
    const wet = this.#all.get(of.id);
    if (wet) wet.matter = of;
    if (wet) wet.met = true;
    if (!reaches(points, volumes, dt)) return undefined;
    let swimmer = this.#swimmers.get(of.id) as Swimmer<Kind> | undefined;
    if (!swimmer?.isOf(of, points)) {
      swimmer = new Swimmer(of, points, soaked());
      this.#swimmers.set(of.id, swimmer as never);
    }
    swimmer.wet = wet;
    swimmer.volumes = volumes;
    return swimmer;
  }

  /** Whether one that rests has to do with water. */
  concerns({ id }: Matter, points: Points, volumes: readonly Volume[]): boolean {
    return this.#all.has(id) || reaches(points, volumes, 0);
  }

  /** Whether the surface moves that one rests on. */
  isRocked(id: number, volumes: readonly Volume[]): boolean {
    const wet = this.#all.get(id);
    if (!wet) return false;
    for (const { source, waves } of volumes)
      if (source === wet.source && waves && !waves.asleep) return true;
    return false;
  }

  forget(id: number): void {
    this.#all.delete(id);
    this.#swimmers.delete(id);
  }

  stepOver(): void {
    for (const { wet, of } of this.#swimmers.values()) {
      if (!wet?.wetted || this.#all.has(wet.id)) continue;
      wet.matter = of;
      this.#all.set(wet.id, wet);
    }
    for (const wet of this.#all.values()) {
      if (wet.wetted) wet.enter(this.#simulation);
      // What sleeps is where it was.
      else if (wet.met) {
        this.#all.delete(wet.id);
        wet.leave(this.#simulation);
      }
      wet.wetted = wet.met = false;
    }
  }

  /** There is no water any more. */
  dry(): void {
    for (const wet of this.#all.values()) wet.leave(this.#simulation);
    this.clear();
  }

  clear(): void {
    this.#all.clear();
    this.#swimmers.clear();
  }

  known(id: number): Record<string, unknown> | undefined {
    return this.#all.get(id)?.known;
  }

  /** What of them is in a volume. */
  within(source: WaterSource): WetMatter[] {
    return [...this.#all.values()].filter((wet) => wet.source === source);
  }

  get kept(): KeptMatter[] {
    return [...this.#all.values()].map((wet) => wet.kept);
  }

  load(kept: readonly KeptMatter[], sources: readonly WaterSource[]): void {
    for (const each of kept) {
      const wet = WetMatter.from(each, sources);
      if (wet) this.#all.set(wet.id, wet);
    }
  }
}

/** Whether any of it may be in water within so many seconds. */
function reaches(
  { places, velocities, count }: Points,
  volumes: readonly Volume[],
  dt: number,
): boolean {
  middle.fill(0);
  for (let i = 0; i < count; i++)
    for (let k = 0; k < 3; k++) middle[k]! += places[3 * i + k]! / count;
  let reach = 0;
  for (let i = 0; i < count; i++) {
    for (let k = 0; k < 3; k++) way[k] = places[3 * i + k]! - middle[k]!;
    let far = lengthOf(way);
    for (let k = 0; k < 3; k++) far += dt * Math.abs(velocities[3 * i + k]!);
    reach = Math.max(reach, far);
  }
  for (const volume of volumes) if (volume.reaches(middle, reach)) return true;
  return false;
}
