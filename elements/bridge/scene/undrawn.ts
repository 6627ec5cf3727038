import type { Readers } from '../scopes/readers.js';
import { dropped, lacks, learnShapes } from '../x3dom/shapes/shapes.js';
import type { X3DDocument } from '../x3dom/x3dom.js';

interface Scene {
  readonly document: X3DDocument | undefined;
  readonly readers: Readers;
}

/** Geometry that x3dom has no node for, and that we draw: x3dom is shown it once it knows it. */
export class Undrawn {
  readonly #scene: Scene;
  readonly #met = new Set<Element>();
  /** What draws it is on its way. */
  pending = false;

  constructor(scene: Scene) {
    this.#scene = scene;
  }

  add(element: Element): void {
    if (!lacks(element)) return;
    this.#met.add(element);
    if (!this.pending) void this.#learn();
  }

  async #learn(): Promise<void> {
    this.pending = true;
    await learnShapes();
    this.pending = false;
    for (const element of this.#met) this.#show(element);
    this.#met.clear();
  }

  #show(element: Element): void {
    if (dropped(element)) this.#scene.document?.onNodeAdded(element, element.parentElement!);
    for (const reader of this.#scene.readers.of(element)) reader.dirty();
  }
}
