import type { World } from '../../physics-core/inside.js';
import { BodyNode } from '../../physics-core/nodes/body/body.js';
import type { StabilityCase } from './case.js';
import { EnergyWatch } from './energy.js';
import { spin, velocity } from './scene.js';

/** Of the energy at the start, and of single precision where there is none. */
const GAIN = 0.01;

/** What is judged in every case, after every step. */
export class CommonWatch {
  readonly #world: World;
  readonly #energy: EnergyWatch | undefined;
  readonly #codes = new Set<string>();
  readonly #which: StabilityCase;
  /** What broke first. */
  why: string | undefined;

  constructor(world: World, which: StabilityCase) {
    this.#world = world;
    this.#which = which;
    for (const { code } of world.problems) this.#codes.add(code);
    world.on('problem', (problem) => this.#codes.add((problem as { code: string }).code));
    if (!which.work) this.#energy = new EnergyWatch(world, which.lowest ?? 0);
  }

  /** After a step. */
  look(): void {
    this.why ??= this.#notFinite() ?? this.#gained();
  }

  /** When the case is over. */
  end(): void {
    this.why ??= this.#told();
  }

  #notFinite(): string | undefined {
    for (const node of this.#world.nodes) {
      if (!(node instanceof BodyNode)) continue;
      const { p, q } = node.pose();
      if (![...p, ...q, ...velocity(node), ...spin(node)].every(Number.isFinite))
        return `not finite at ${this.#time}`;
    }
  }

  #gained(): string | undefined {
    if (!this.#energy) return;
    const { start } = this.#energy;
    const gain = this.#energy.look() - start;
    if (gain > GAIN * Math.abs(start) + 1e-9)
      return `gains ${((100 * gain) / Math.abs(start)).toFixed(1)} % of its energy at ${this.#time}`;
  }

  get #time(): string {
    return `${this.#world.time.toFixed(2)} s`;
  }

  #told(): string | undefined {
    const { tells = [], mayTell = [] } = this.#which;
    const missing = tells.find((code) => !this.#codes.has(code));
    if (missing) return `${missing} is not told`;
    const known = [...tells, ...mayTell];
    const other = [...this.#codes].find((code) => !known.includes(code));
    return other && `tells of ${other}`;
  }
}
