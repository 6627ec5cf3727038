import { debugLines, type DebugLines } from '../../../physics-core/inside.js';
import type { PageWorld } from '../nodes/worlds.js';
import type { Scene } from '../scene.js';
import type { X3DDocument } from '../x3dom/x3dom.js';
import { LineShape } from './line-shape.js';

/** The debug drawing of one world, in the world frame of its `<x3d>`. */
export class Sketch {
  readonly #scene: Scene;
  readonly #world: PageWorld;
  readonly #lines: DebugLines;
  #shape: LineShape | undefined;
  /** Where the shape stands: x3dom may read the `<x3d>` again. */
  #document: X3DDocument | undefined;

  constructor(scene: Scene, world: PageWorld, lines: DebugLines) {
    this.#scene = scene;
    this.#world = world;
    this.#lines = lines;
  }

  draw(): void {
    const start = performance.now();
    this.#lines.update();
    this.#inFileUnits();
    this.#stand()?.show(this.#lines);
    this.#scene.requestRender();
    this.#world.registry.debugging.spent += performance.now() - start;
  }

  #inFileUnits(): void {
    const length = this.#scene.readPage()?.units.length ?? 1;
    if (length === 1) return;
    const { positions, count } = this.#lines;
    for (let i = 0; i < 6 * count; i++) positions[i] /= length;
  }

  #stand(): LineShape | undefined {
    const { document } = this.#scene;
    if (document !== this.#document) {
      this.#document = document;
      this.#shape = document && new LineShape(document);
    }
    return this.#shape;
  }

  remove(): void {
    this.#shape?.remove();
    this.#lines.dispose();
    this.#scene.requestRender();
  }
}

export const makeSketch = async (scene: Scene, world: PageWorld): Promise<Sketch> =>
  new Sketch(scene, world, await debugLines(world));
