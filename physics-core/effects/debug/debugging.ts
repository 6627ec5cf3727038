import { Chunk } from '../../base/chunk.js';
import type { Simulation } from '../../dynamics/simulation.js';
import { Effect, type Cause, type EffectDescriptor } from '../effect/effect.js';
import type { ColorMeaning } from './colors.js';
import type { DebugLines, DebugScene, DrawnSimulation } from './debug-lines.js';

/** What only a world needs that is drawn as Bullet has it. */
interface DebugCode {
  lines(simulation: DrawnSimulation, scene: DebugScene): DebugLines;
  readonly legend: readonly ColorMeaning[];
}

export const outlines = new Chunk<DebugCode>({
  name: 'debug',
  causes: 'debug of a RigidBodyCollection, or `debugLines()`',
});

/** Collections that ask to be drawn as Bullet has them. Who draws hears of it by the world's `debug`. */
export class Debugging extends Effect {
  readonly #simulation: Simulation;

  constructor(simulation: Simulation) {
    super();
    this.#simulation = simulation;
  }

  override need(node: Cause, reason: string): void {
    const before = this.active;
    super.need(node, reason);
    if (!before) this.#simulation.emit('debug', true);
  }

  override release(node: Cause): void {
    const before = this.active;
    super.release(node);
    if (before && !this.active) this.#simulation.emit('debug', false);
  }

  /** What is drawn is no longer true. */
  stale(): void {
    if (this.active) this.#simulation.work();
  }
}

export const debugging: EffectDescriptor<Debugging> = {
  name: 'debug drawing',
  chunk: outlines,
  causes: 'debug of a RigidBodyCollection',
  load: (simulation) => new Debugging(simulation),
};
