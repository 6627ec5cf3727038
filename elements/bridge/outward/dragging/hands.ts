import type { Scene } from '../../scene/scene.js';
import type { DraggableBody } from './body.js';
import { Handles } from './handles.js';
import { Pointers } from './pointers.js';
import { View } from './view.js';

/** What people drag the bodies of a scene with. */
export class Hands {
  readonly #pointers: Pointers;
  readonly #handles: Handles;

  constructor(scene: Scene) {
    const view = new View(scene.x3d);
    this.#pointers = new Pointers(scene, view);
    this.#handles = new Handles(scene, view);
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
