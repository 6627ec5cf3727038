import { hypot } from '../base/exact/index.js';
import type { LevelRun } from './level-run.js';

/** Share of the longest way of a body, and least distance (metres), from which on two runs no longer agree. */
const AGREEMENT = { share: 0.01, least: 1e-3 };

/** A run against the finest one. */
export interface Difference {
  /** The greatest distance of a body from where the finest run has it, metres, and the number of that body. */
  position: number;
  worst: number;
  /** Sum over the moments of what its energy differs by, joules. */
  energy: number;
  moments: number;
  /** The energy in play: the most that was motion, or went into or out of height. */
  swing: number;
}

/**
 * Compares runs with the finest one, moment by moment. A scene is chaotic where a twin, pushed by no more than rounding
 * would, parts from the run it is a twin of: then errors count up to the horizon, the moment where the two finest runs
 * (or the twins) part. Two finest runs that part without that are not converged, which is an error like any other.
 */
export class Comparison {
  readonly #runs: readonly LevelRun[];
  readonly #finest: LevelRun;
  readonly #twin: LevelRun;
  readonly #start: Float64Array;
  readonly #heights: readonly number[];
  #differences: Difference[];
  /** When the two finest runs parted, and the differences until then. */
  #parted: { time: number; differences: Difference[] } | undefined;
  #way = 0;
  /** Seconds up to which runs agree; undefined: all the time. */
  horizon: number | undefined;
  /** Metres. */
  tolerance = AGREEMENT.least;

  /** `runs`: coarse to fine. `twin`: one of the finest but one. */
  constructor(runs: readonly LevelRun[], twin: LevelRun) {
    this.#runs = runs;
    this.#finest = runs.at(-1)!;
    this.#twin = twin;
    this.#start = this.#finest.positions.slice();
    this.#heights = runs.map(({ height }) => height);
    this.#differences = runs.map(() => ({
      position: 0,
      worst: 0,
      energy: 0,
      moments: 0,
      swing: 0,
    }));
  }

  get #second(): LevelRun {
    return this.#runs.at(-2) ?? this.#finest;
  }

  get differences(): readonly Difference[] {
    return this.#differences;
  }

  /** All runs stand at this moment, seconds from the start. */
  compare(time: number): void {
    if (this.horizon !== undefined) return;
    this.#way = Math.max(this.#way, distance(this.#finest.positions, this.#start).most);
    this.tolerance = Math.max(AGREEMENT.least, AGREEMENT.share * this.#way);
    this.#part(time);
    if (this.horizon === undefined) this.#runs.forEach((run, i) => this.#note(run, i));
  }

  #part(time: number): void {
    const parts = (a: LevelRun, b: LevelRun): boolean =>
      distance(a.positions, b.positions).most > this.tolerance;
    if (parts(this.#second, this.#finest))
      this.#parted ??= { time, differences: structuredClone(this.#differences) };
    if (!parts(this.#twin, this.#second)) return;
    this.horizon = this.#parted?.time ?? time;
    this.#differences = this.#parted?.differences ?? this.#differences;
  }

  #note(run: LevelRun, i: number): void {
    const difference = this.#differences[i]!;
    const { most, at } = distance(run.positions, this.#finest.positions);
    if (most > difference.position) Object.assign(difference, { position: most, worst: at });
    const finest = this.#finest;
    difference.energy += Math.abs(run.motion - finest.motion + (run.height - finest.height));
    difference.moments++;
    const lifted = Math.abs(run.height - this.#heights[i]!);
    difference.swing = Math.max(difference.swing, run.motion, lifted);
  }

  /** Mean difference in energy, as a share of the energy in play. */
  energyError(i: number): number {
    const { energy, moments, swing } = this.#differences[i]!;
    const most = Math.max(swing, this.#differences.at(-1)!.swing);
    return energy > 0 ? energy / moments / most : 0;
  }
}

/** The greatest distance of two bodies of one number, and that number. */
function distance(a: Float64Array, b: Float64Array): { most: number; at: number } {
  let [most, at] = [0, 0];
  for (let i = 0; i < a.length; i += 3) {
    const apart = hypot(a[i]! - b[i]!, a[i + 1]! - b[i + 1]!, a[i + 2]! - b[i + 2]!);
    if (apart > most) [most, at] = [apart, i / 3];
  }
  return { most, at };
}
