import type { Drawing } from '../drawing/drawing.js';
import type { Binding } from '../nodes/binding.js';
import type { Readers } from '../scopes/readers.js';
import { isTransform } from '../words/dom.js';
import { drawnPose, moveTo } from './body-state.js';
import type { StartPose } from './plan.js';

/** Bodies follow the edits of the Transforms that they move; others are drawn again where they are. */
export class Following {
  readonly #drawing: Drawing;
  readonly #readers: Readers;
  /** Transforms that were written to, and whether anything else than before. */
  readonly #edited = new Map<Element, boolean>();
  readonly #redraw = new Set<Binding>();
  /** Bodies that follow an edit: their Transforms are there already, their drawn poses come with the next frame. */
  readonly #jumped = new Set<Binding>();

  constructor(drawing: Drawing, readers: Readers) {
    this.#drawing = drawing;
    this.#readers = readers;
  }

  /** `again`: with what it said already. */
  edited(element: Element, again: boolean): void {
    this.#edited.set(element, !again || (this.#edited.get(element) ?? false));
  }

  redraw(binding: Binding): void {
    this.#redraw.add(binding);
  }

  /** Transforms whose edits nobody has followed yet. */
  get size(): number {
    return this.#edited.size;
  }

  followEdits(): void {
    for (const [element, isNew] of this.#edited) {
      const own = this.#drawing.bodyMoving(element);
      const under = this.#drawing.bodiesUnder(element);
      for (const binding of new Set([...(own ? [own] : []), ...under])) {
        if (!isNew || !this.#follow(binding, element)) this.#redraw.add(binding);
      }
      for (const reader of this.#readers.of(element)) reader.dirty();
    }
    this.#edited.clear();
  }

  /** A body goes where the author put the Transform that it moves, or one above. */
  #follow(binding: Binding, edited: Element): boolean {
    const targets = this.#drawing.targetsOf(binding).filter(({ element }) => isTransform(element));
    const target = targets.find(({ element }) => element === edited) ?? targets[0];
    if (!target || !binding.node) return false;
    this.jump(binding, drawnPose(target));
    binding.dirty();
    return true;
  }

  /** Puts a body where its Transform is. */
  jump(binding: Binding, pose: StartPose): void {
    moveTo(binding.node!, pose);
    this.#jumped.add(binding);
  }

  draw(): void {
    for (const binding of this.#redraw)
      if (!this.#jumped.has(binding)) this.#drawing.redraw(binding);
    this.#redraw.clear();
    this.#jumped.clear();
  }
}
