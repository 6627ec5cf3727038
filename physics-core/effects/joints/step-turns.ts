import { dot3 } from '../../base/flat-math.js';
import type { Body } from '../../dynamics/body.js';
import { levels } from '../../dynamics/levels.js';
import type { Simulation } from '../../dynamics/simulation.js';
import { VELOCITY } from '../../engine/moving-bodies.js';
import { MOST_PARTS, MOST_TURN, MOST_TURN_IN_TOUCH } from '../../solver/tolerances.js';

/**
 * How far steps turn what joints hold. Where a body turns on within a step, its joints pull and its axes lie elsewhere at
 * the end of it: steps are split until all turn little in each part. What touches something is spun up and braked by that
 * from step to step, and is worth no split world for its axis; it only must not turn by half a turn, which nobody could tell
 * from one back.
 */
export class StepTurns {
  readonly #simulation: Simulation;
  #bodies: readonly Body[] = [];

  constructor(simulation: Simulation) {
    this.#simulation = simulation;
  }

  take(bodies: readonly Body[]): void {
    this.#bodies = bodies;
  }

  /** Into how many parts a step is to be split; `touched`: whether contacts acted on it in the last one. */
  parts(dt: number, touched: (body: Body) => boolean): number {
    const { bodies } = this.#simulation;
    const { velocities } = bodies;
    // Of slower ones nothing else is asked.
    const slow = (MOST_TURN / dt) ** 2;
    let most = 1;
    for (const body of this.#bodies) {
      const at = body.slot * VELOCITY + 3;
      const square = dot3(velocities, at, velocities, at);
      if (!(square > slow) || bodies.asleep(body)) continue;
      const turn = Math.sqrt(square) * dt;
      const parts = turn / (touched(body) ? MOST_TURN_IN_TOUCH : MOST_TURN);
      if (parts > MOST_PARTS) reportTooFast(body, turn / dt, dt);
      most = Math.max(most, parts);
    }
    return most;
  }
}

/** Turns no more than this, rad/s, are followed by steps of so many seconds. */
const fastestAt = (dt: number): number => (MOST_TURN * MOST_PARTS) / dt;

function reportTooFast(body: Body, spin: number, dt: number): void {
  const better = levels.find(({ timeStep }) => spin <= fastestAt(timeStep));
  body.report({
    code: 'too-fast',
    severity: 'warning',
    attribute: 'angularVelocity',
    value: spin,
    used: `${MOST_PARTS} parts of each step`,
    message: `${body.label} spins at ${Math.round(spin)} rad/s: what joints hold keeps its axis up to ${Math.round(fastestAt(dt))} rad/s at this accuracy; ${better ? `accuracy="${better.name}" or better follows it` : 'no accuracy follows it'}`,
  });
}
