import { SHORTEST_LINK } from '../tolerances.js';
import type { Coils } from './coils.js';
import { Spots, SPOTS } from './spots.js';

/** A point that nothing holds, or that goes where it is taken; else the number of the body that it is tied to. */
export const FREE = -2;
export const HELD = -1;

/** Points and the links between them, in flat arrays: what a rope is made of, and how it stands in a step. */
export class Strand {
  readonly points: number;

  // ---- what it is ---------------------------------------------------------------------------------------------------

  /** Of each point, kg. */
  readonly masses: Float64Array;
  /** Of each link, metres; and how far it gives way, metres for each newton (0: it does not stretch). */
  readonly lengths: Float64Array;
  readonly softness: Float64Array;
  /** Who holds each point: FREE, HELD, or the number of a body. */
  readonly holders: Int32Array;

  // ---- from step to step --------------------------------------------------------------------------------------------

  /** Metres, and m/s in the middle of the last step. */
  readonly places: Float64Array;
  readonly velocities: Float64Array;
  /** Of each link, how it pulled in the last step: N s for each metre of it. */
  readonly pulls: Float64Array;

  // ---- a step -------------------------------------------------------------------------------------------------------

  /** As it would be if nothing pulled, m/s; and as it is found. */
  readonly free: Float64Array;
  readonly found: Float64Array;
  /** Of tied points: from the body's centre of mass, metres, a step ago, when the step begins and when it ends. */
  readonly armsBefore: Float64Array;
  readonly arms: Float64Array;
  readonly armsAfter: Float64Array;
  /** Of each link, from its first point to its second: when the step begins, and what that changed by in the last one. */
  readonly ways: Float64Array;
  readonly changes: Float64Array;

  // ---- what it touches ------------------------------------------------------------------------------------------------

  /** By its points, and by its links between them. */
  readonly knots: Spots;
  readonly between: Spots;
  /** Where it meets itself; undefined: it does not. */
  coils: Coils | undefined;

  constructor(points: number) {
    const links = points - 1;
    this.points = points;
    this.masses = new Float64Array(points);
    this.lengths = new Float64Array(links);
    this.softness = new Float64Array(links);
    this.holders = new Int32Array(points).fill(FREE);
    this.places = new Float64Array(3 * points);
    this.velocities = new Float64Array(3 * points);
    this.pulls = new Float64Array(links);
    this.free = new Float64Array(3 * points);
    this.found = new Float64Array(3 * points);
    this.armsBefore = new Float64Array(3 * points);
    this.arms = new Float64Array(3 * points);
    this.armsAfter = new Float64Array(3 * points);
    this.ways = new Float64Array(3 * links);
    this.changes = new Float64Array(3 * links);
    this.knots = new Spots(points, 1);
    this.between = new Spots(links, SPOTS);
  }

  /** Gives it a line of points, and what it weighs: each link half to either of its ends. */
  lay(places: ArrayLike<number>, mass: number): void {
    const { points, lengths, masses } = this;
    let whole = 0;
    this.places.set(places);
    for (let i = 0; i < points - 1; i++) {
      const x = places[3 * i + 3]! - places[3 * i]!;
      const y = places[3 * i + 4]! - places[3 * i + 1]!;
      const z = places[3 * i + 5]! - places[3 * i + 2]!;
      whole += lengths[i] = Math.max(SHORTEST_LINK, Math.sqrt(x * x + y * y + z * z));
    }
    masses.fill(0);
    for (let i = 0; i < points - 1; i++) {
      const half = (mass * lengths[i]!) / whole / 2;
      masses[i]! += half;
      masses[i + 1]! += half;
    }
  }

  /** What a step begins with. */
  begin(dt: number): void {
    const { places, velocities, ways, changes, points } = this;
    this.knots.begin();
    this.between.begin();
    for (let i = 0; i < 3 * points - 3; i++) {
      ways[i] = places[i + 3]! - places[i]!;
      changes[i] = dt * (velocities[i + 3]! - velocities[i]!);
    }
  }

  /** It goes where it was found to go. */
  move(dt: number): void {
    const { places, velocities, found } = this;
    for (let i = 0; i < places.length; i++) {
      velocities[i] = found[i]!;
      places[i]! += dt * found[i]!;
    }
  }
}
