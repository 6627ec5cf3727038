import type { CaseScene } from '../case.js';
import type { Running } from '../engines/engine.js';
import { energyIn } from '../run/energy.js';
import { widestGap } from '../run/gap.js';
import { overlapIn } from './overlap.js';

/** What a run leaves, from its middle on. */
export interface Errors {
  /** Metres: the deepest overlap, and the widest gap of a joint; null where there is none. */
  overlap: number;
  gap: number | null;
  /** Energy that came from nowhere, as a share of that at the start: all rises from look to look. Null where it is driven. */
  energy: number | null;
}

/** Looks at a running scene. */
export class Looks {
  readonly #scene: CaseScene;
  readonly #running: Running;
  readonly #widest: () => number;
  readonly #driven: boolean;
  readonly #start: number;
  #last: number;
  #rises = 0;
  #overlap = 0;
  #gap = 0;

  constructor(scene: CaseScene, running: Running, driven: boolean) {
    const gap = widestGap(scene);
    this.#scene = scene;
    this.#running = running;
    this.#widest = () => gap(running);
    this.#driven = driven;
    this.#start = this.#last = this.#energy();
  }

  #energy(): number {
    return this.#driven ? 0 : energyIn(this.#scene, this.#running);
  }

  /** Of bodies that fall, and, later on, of how they lie. */
  async look(late: boolean): Promise<void> {
    const energy = this.#energy();
    this.#rises += Math.max(0, energy - this.#last);
    this.#last = energy;
    if (!late) return;
    this.#gap = Math.max(this.#gap, this.#widest());
    this.#overlap = Math.max(this.#overlap, await overlapIn(this.#scene, this.#running));
  }

  get errors(): Errors {
    const { joints = [] } = this.#scene;
    return {
      overlap: this.#overlap,
      gap: joints.length > 0 ? this.#gap : null,
      energy: this.#driven ? null : this.#rises / this.#start,
    };
  }
}
