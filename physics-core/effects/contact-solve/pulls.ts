import type { Numbered } from '../effect/effect.js';
import { add, length, scale, subtract } from '../../base/math.js';
import type { Body } from '../../dynamics/body.js';
import type { Vec3 } from '../../fields/types.js';
import { StepWay, through, type PlaceInTime } from '../drag/smooth-way.js';

/** Steps that say how a pull goes on. */
const STEPS = 4;

/**
 * Of changes of a pull, how much may change from one to the next but one: the square of what a spring's swing turns in a
 * step, radians. Up to here it loses less than a hundredth in two thousand steps.
 */
const SMOOTH = 0.02;

/** m/s²: rounding of what does not change. */
const STEADY = 1e-4;

/**
 * What pulls bodies, m/s². What page code gives anew in each step it gives by where they are at its start, as springs do:
 * within the step that goes on as it did in the last ones.
 */
export class Pulls {
  readonly #last = new Map<Body, PlaceInTime[]>();

  forget(body: Body): void {
    this.#last.delete(body);
  }

  forgetAll(): void {
    this.#last.clear();
  }

  save(): [id: number, last: PlaceInTime[]][] {
    return [...this.#last].map(([{ id }, last]) => [id, structuredClone(last)]);
  }

  load(kept: readonly [id: number, last: PlaceInTime[]][], { body }: Numbered): void {
    this.#last.clear();
    for (const [id, last] of kept) {
      const of = body(id);
      if (of) this.#last.set(of, last);
    }
  }

  /** Where a pull that varies would take a body in the step that begins, from rest; undefined: nobody knows. */
  of(body: Body, pull: Vec3, time: number, dt: number): StepWay | undefined {
    const last = this.#last.get(body) ?? [];
    const goesOn = last.length > 0 && Math.abs(time - last[0]!.time - dt) < dt / 2;
    const samples = [{ time, p: pull }, ...(goesOn ? last.slice(0, STEPS - 1) : [])];
    this.#last.set(body, samples);
    return isSmooth(samples) ? wayOf(through(samples, time)) : undefined;
  }
}

/** Where one that stays as it is takes what it pulls. */
export const steadily = (pull: Vec3): StepWay => wayOf([pull]);

function isSmooth(samples: readonly PlaceInTime[]): boolean {
  if (samples.length < STEPS) return false;
  const changes = samples.slice(1).map(({ p }, i) => subtract(samples[i]!.p, p));
  const [first, second, third] = changes as [Vec3, Vec3, Vec3];
  const change = length(add(subtract(first, scale(second, 2)), third));
  return change <= STEADY + SMOOTH * Math.max(...changes.map(length));
}

const NONE: Vec3 = [0, 0, 0];

/** Twice the integral of a polynomial. */
const wayOf = (powers: readonly Vec3[]): StepWay =>
  new StepWay([NONE, NONE, ...powers.map((c, k) => scale(c, 1 / ((k + 1) * (k + 2))))]);
