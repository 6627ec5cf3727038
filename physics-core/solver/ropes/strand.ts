import { SHORTEST_LINK } from '../tolerances.js';

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
  /** Of each point, how what it touches pushed and rubbed it, N s: along the normal, and along the surface. */
  readonly presses: Float64Array;
  readonly rubs: Float64Array;
  /** The same in the step before. */
  readonly pressed: Float64Array;
  readonly rubbed: Float64Array;

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

  // ---- what its points touch ------------------------------------------------------------------------------------------

  /** 1: there is something to touch. */
  readonly touches: Uint8Array;
  readonly normals: Float64Array;
  /** How far away that is when the step begins, metres; how fast it is, m/s. */
  readonly gaps: Float64Array;
  readonly surfaces: Float64Array;
  readonly frictions: Float64Array;
  /** How it gives way: m/s for each N s. */
  readonly yields: Float64Array;

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
    this.presses = new Float64Array(points);
    this.rubs = new Float64Array(3 * points);
    this.pressed = new Float64Array(points);
    this.rubbed = new Float64Array(3 * points);
    this.free = new Float64Array(3 * points);
    this.found = new Float64Array(3 * points);
    this.armsBefore = new Float64Array(3 * points);
    this.arms = new Float64Array(3 * points);
    this.armsAfter = new Float64Array(3 * points);
    this.ways = new Float64Array(3 * links);
    this.changes = new Float64Array(3 * links);
    this.touches = new Uint8Array(points);
    this.normals = new Float64Array(3 * points);
    this.gaps = new Float64Array(points);
    this.surfaces = new Float64Array(3 * points);
    this.frictions = new Float64Array(points);
    this.yields = new Float64Array(points);
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
    for (let i = 0; i < points; i++) this.pressed[i] = this.presses[i]!;
    for (let j = 0; j < 3 * points; j++) this.rubbed[j] = this.rubs[j]!;
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
