import { copyInto } from '../world/snapshot/copy.js';
import type { Level } from '../dynamics/levels.js';
import type { Snapshot } from '../world/snapshot/snapshot.js';
import type { Call, HeldDrag } from '../world/recording.js';
import { World } from '../world/world.js';
import { Redoing } from './calls.js';

/** Where a run may begin. */
export interface Beginning {
  /** Steps since the recording began. */
  readonly step: number;
  readonly snapshot: Snapshot;
  readonly drags: readonly HeldDrag[];
}

/**
 * A world beside another, in which that one's past is run anew: nobody hears of it, and the other does not move. Whoever makes
 * it destroys it.
 */
export class Twin {
  readonly world: World;
  readonly #level: Level | undefined;
  #redoing!: Redoing;
  #step = 0;
  #next = 0;
  readonly #calls: readonly Call[];

  /** `level`: another than that of the world, whatever is asked for. */
  constructor(calls: readonly Call[], level?: Level) {
    this.world = new World({ console: false, ...(level && { level }) });
    this.#level = level;
    this.#calls = calls;
  }

  /** Becomes what the other was; each `next` goes on by a node. */
  *begin({ engine }: World, { step, snapshot, drags }: Beginning): Generator<number, void> {
    const elsewhere = this.#level !== undefined && this.#level.name !== snapshot.level;
    for (const _ of copyInto(this.world, snapshot, engine, {}, elsewhere)) yield 0;
    this.#redoing = new Redoing(this.world);
    for (const { drag, body, point } of drags) this.#redoing.hold(drag, body, point);
    this.#step = step;
    const first = this.#calls.findIndex((call) => call.step >= step);
    this.#next = first < 0 ? this.#calls.length : first;
  }

  /** To the end of a step; what was done after it is still to come. Each `next` goes on by a step. */
  *runTo(until: number): Generator<number, void> {
    const from = this.#step;
    while (this.#step < until) {
      this.redo();
      this.world.step(1);
      this.#step++;
      yield (this.#step - from) / (until - from);
    }
  }

  /** Does what was done before the next step. */
  redo(): void {
    while (this.#calls[this.#next]?.step === this.#step)
      this.#redoing.do(this.#calls[this.#next++]!);
  }
}
