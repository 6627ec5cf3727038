import type { Binding } from '../nodes/binding.js';
import { standInOf } from '../document/shortcuts.js';
import type { Scene } from '../scene.js';

/** Which body, or which collidable of one, moves which Transform. */
export class Drivers {
  readonly #scene: Scene;
  readonly #drivers = new Map<Element, Binding>();

  constructor(scene: Scene) {
    this.#scene = scene;
  }

  /** Finds out what a body or collidable stands for; other nodes that read the same Transform hear of it. */
  update(binding: Binding): void {
    const before = binding.standIn?.transform;
    binding.standIn = standInOf(binding);
    const after = binding.standIn?.transform;
    if (before === after) return;
    this.#release(binding, before);
    if (after) this.#drivers.set(after, binding);
    for (const element of [before, after]) {
      if (!element) continue;
      for (const reader of this.#scene.readers.of(element))
        if (reader !== binding) this.#scene.dirty(reader);
    }
  }

  stop(binding: Binding): void {
    this.#release(binding, binding.standIn?.transform);
    binding.standIn = undefined;
  }

  #release(binding: Binding, transform: Element | undefined): void {
    if (transform && this.#drivers.get(transform) === binding) this.#drivers.delete(transform);
  }

  of(transform: Element): Binding | undefined {
    return this.#drivers.get(transform);
  }
}
