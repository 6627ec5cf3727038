import type { Stage } from '../stage.js';
import type { DraggableBody } from '../body.js';
import { Handles } from './handles.js';
import { Pointers } from './pointers.js';
import { View } from './view.js';

/** What people drag the bodies of a scene with. */
export class Hands {
  readonly #pointers: Pointers;
  readonly #handles: Handles;

  constructor(stage: Stage) {
    const view = new View(stage.x3d);
    this.#pointers = new Pointers(stage, view);
    this.#handles = new Handles(stage, view);
  }

  add(body: DraggableBody): void {
    this.#handles.add(body);
  }

  remove(body: DraggableBody): void {
    this.#handles.remove(body);
  }

  destroy(): void {
    this.#pointers.destroy();
    this.#handles.destroy();
  }
}
