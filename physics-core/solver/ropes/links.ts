import { dot3 } from '../../base/flat-math.js';
import { LINK_COMPLIANCE, ROPE_MISS, ROPE_RETURN, TAUT } from '../tolerances.js';
import { HELD, type Strand } from './strand.js';

/**
 * How the direction of a pull is reckoned from the ways of its link: `after` of what it changes by in this step, less `before`
 * of what it did in the last one.
 */
export interface Directions {
  readonly after: number;
  readonly before: number;
}

/**
 * By the mean of the three places where the link is a step ago, now, and in a step (Newmark, β = 1/4): second order,
 * stable however hard it pulls, and energy is kept. Where a link turns too far in a step there is no such pull.
 */
export const EVEN: Directions = { after: 0.25, before: 0.25 };

/**
 * By where the link is when the step ends: what is found are the places nearest to those without pulls, in kinetic energy,
 * among those where no link is too long. That set is convex: there is always one, and nothing gains energy.
 */
export const NEAREST: Directions = { after: 1, before: 0 };

/** The links of a strand in a round of the search: how far each is too long, and which way it pulls. */
export class Links {
  readonly strand: Strand;
  /** 1: it is taut. */
  readonly taut: Uint8Array;
  /** Metres too long. */
  readonly excess: Float64Array;
  /** Of unit length, where the step ends; and, in metres, which way it pulls. */
  readonly units: Float64Array;
  readonly pulling: Float64Array;
  /** Of one that stretches, what it counts by how long it was before, metres. */
  readonly past: Float64Array;
  /** Metres for each N s a metre. */
  readonly compliance: Float64Array;
  readonly #firm: Float64Array;
  readonly #soft: Float64Array;
  /** Metres too long when the step begins, and a step ago. */
  readonly #before: Float64Array;
  readonly #longBefore: Float64Array;
  /** What a pull resists a change of the way by, N s for each m/s. */
  readonly stiffness: Float64Array;
  /** How long each may be when the step ends, metres: one that is too long when it begins comes back in time. */
  readonly limits: Float64Array;

  constructor(strand: Strand) {
    const links = strand.points - 1;
    this.strand = strand;
    this.taut = new Uint8Array(links);
    this.excess = new Float64Array(links);
    this.units = new Float64Array(3 * links);
    this.pulling = new Float64Array(3 * links);
    this.past = new Float64Array(links);
    this.limits = new Float64Array(links);
    this.compliance = new Float64Array(links);
    this.#firm = new Float64Array(links);
    this.#soft = new Float64Array(links);
    this.#before = new Float64Array(links);
    this.#longBefore = new Float64Array(links);
    this.stiffness = new Float64Array(links);
  }

  begin(dt: number): void {
    const { masses, lengths, softness, ways, points } = this.strand;
    for (let i = 0; i < points - 1; i++) {
      const mass = (2 * masses[i]! * masses[i + 1]!) / (masses[i]! + masses[i + 1]!);
      const length = lengths[i]!;
      const now = Math.sqrt(dot3(ways, 3 * i, ways, 3 * i));
      this.limits[i] =
        softness[i]! > 0
          ? length
          : Math.max(length, now - Math.min(ROPE_RETURN * dt, now - length));
      this.#firm[i] = (LINK_COMPLIANCE * dt * length) / mass;
      // A pull of 1 N s a metre is as many newtons as the link is long.
      this.#soft[i] = (softness[i]! * length * now) / dt;
      this.#before[i] = now - length;
      this.#longBefore[i] = this.#lengthBefore(i) - length;
    }
  }

  #lengthBefore(i: number): number {
    const { ways, changes } = this.strand;
    let square = 0;
    for (let k = 3 * i; k < 3 * i + 3; k++) square += (ways[k]! - changes[k]!) ** 2;
    return Math.sqrt(square);
  }

  /** One body, or nobody, has both of its ends: it is as long as it is. */
  #isGiven(i: number): boolean {
    const { holders } = this.strand;
    return holders[i]! >= HELD && holders[i] === holders[i + 1];
  }

  #isLong(i: number): boolean {
    const { ways, lengths } = this.strand;
    const length = lengths[i]! * (1 - TAUT);
    return ways[3 * i]! ** 2 + ways[3 * i + 1]! ** 2 + ways[3 * i + 2]! ** 2 >= length * length;
  }

  /**
   * By the velocities found so far. A link only pulls. In the first round of a search all are taut that are as long as they
   * may be: a rope that goes taut from one end would else do so by a link in each round.
   */
  read(dt: number, { after, before }: Directions, first: boolean): void {
    const { ways, changes, found, lengths, pulls, masses, points } = this.strand;
    const { limits } = this;
    const { units, pulling, excess, taut, stiffness } = this;
    for (let i = 0, j = 0; i < points - 1; i++, j += 3) {
      let square = 0;
      for (let k = j; k < j + 3; k++) {
        const change = dt * (found[k + 3]! - found[k]!);
        const way = ways[k]! + change;
        units[k] = way;
        pulling[k] = ways[k]! + after * change - before * changes[k]!;
        square += way * way;
      }
      const length = Math.sqrt(square);
      // Both ends in one place: any way apart is as good.
      if (length > 0) for (let k = j; k < j + 3; k++) units[k]! /= length;
      else units[j + 1] = 1;
      let over = length - limits[i]!;
      // What stretches pulls by the same mean of its lengths as gives its direction.
      if (this.#soft[i]! > 0) {
        const past = (1 - after - before) * this.#before[i]! + before * this.#longBefore[i]!;
        over += this.past[i] = past / after;
      }
      this.compliance[i] = this.#firm[i]! + this.#soft[i]! / after;
      const mass = (2 * masses[i]! * masses[i + 1]!) / (masses[i]! + masses[i + 1]!);
      const pull = pulls[i]! + (over * mass) / (2 * dt * lengths[i]!);
      // What only just hangs neither pulls nor does not.
      const pulled = pulls[i]! > 0 ? pull > 0 : over > ROPE_MISS;
      taut[i] = (pulled || (first && this.#isLong(i))) && !this.#isGiven(i) ? 1 : 0;
      if (taut[i]) {
        excess[i] = over - this.compliance[i]! * pulls[i]!;
        stiffness[i] = after * dt * Math.max(0, pulls[i]!);
      } else pulls[i] = stiffness[i] = 0;
    }
  }
}
