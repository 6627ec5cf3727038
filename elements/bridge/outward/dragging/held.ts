import type { DragEnd, Hold, Vec3 } from '../../../../physics-core/inside.js';
import type { Binding } from '../../nodes/binding.js';
import type { Stage } from '../stage.js';
import { setState } from '../../base/states.js';
import type { By, DraggableBody } from '../body.js';
import type { Picked } from './picking.js';

/** How many hold each body: its state ends with the last. */
const holders = new WeakMap<Binding, number>();

/** One drag as the page sees it: its events, its state, and where it is to be. */
export class Held {
  readonly body: DraggableBody;
  readonly binding: Binding;
  readonly by: By;
  readonly #stage: Stage;
  readonly #onend: (reason: DragEnd) => void;
  #drag: Hold | undefined;
  /** Metres. */
  point: Vec3;

  /** Undefined where a listener of `bodydragstart` forbids it, or the body can't be held. */
  static take(
    stage: Stage,
    picked: Picked,
    by: By,
    onend: (reason: DragEnd) => void,
  ): Held | undefined {
    const held = new Held(stage, picked, by, onend);
    return held.#begin() ? held : undefined;
  }

  private constructor(
    stage: Stage,
    { body, binding, point }: Picked,
    by: By,
    onend: (reason: DragEnd) => void,
  ) {
    this.#stage = stage;
    this.body = body;
    this.binding = binding;
    this.by = by;
    this.point = point;
    this.#onend = onend;
  }

  #begin(): boolean {
    if (!this.#tell('bodydragstart')) return false;
    this.#drag = this.body.drag(this.point, (reason) => this.#ended(reason));
    if (!this.#drag) {
      this.#tell('bodydragend', 'disabled');
      return false;
    }
    holders.set(this.binding, (holders.get(this.binding) ?? 0) + 1);
    setState(this.binding.element, 'dragging', true);
    return true;
  }

  #tell(type: string, reason?: DragEnd): boolean {
    const { time } = this.body.world;
    const { dragMode: mode } = this.body;
    const detail = { point: [...this.point], mode, by: this.by, time };
    return this.#stage.events.drag(this.binding, type, { ...detail, ...(reason && { reason }) });
  }

  move(point: Vec3): void {
    if (!this.#drag?.held) return;
    this.point = point;
    this.#drag.move(point);
    // The move may have found that it is over.
    if (this.#drag?.held) this.#tell('bodydrag');
  }

  /** Where people asked for less motion nothing flies on. */
  end(): void {
    this.#drag?.end(matchMedia('(prefers-reduced-motion: reduce)').matches);
  }

  cancel(): void {
    this.#drag?.cancel();
  }

  #ended(reason: DragEnd): void {
    const left = holders.get(this.binding)! - 1;
    holders.set(this.binding, left);
    if (left === 0) setState(this.binding.element, 'dragging', false);
    this.#onend(reason);
    this.#tell('bodydragend', reason);
  }
}
