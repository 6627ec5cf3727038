import { debugging } from '../../../../physics-core/inside.js';
import { debugLines, type DebugLines } from '../../../../physics-core/debug-lines.js';
import type { PageWorld } from '../../nodes/surroundings.js';
import type { Stage } from '../stage.js';
import type { X3DDocument } from '../../x3dom/x3dom.js';
import { LineShape } from './line-shape.js';

/** The debug drawing of one world, in the world frame of its `<x3d>`. */
export class Sketch {
  readonly #stage: Stage;
  readonly #world: PageWorld;
  readonly #lines: DebugLines;
  #shape: LineShape | undefined;
  /** Where the shape stands: x3dom may read the `<x3d>` again. */
  #document: X3DDocument | undefined;

  constructor(stage: Stage, world: PageWorld, lines: DebugLines) {
    this.#stage = stage;
    this.#world = world;
    this.#lines = lines;
  }

  draw(): void {
    const start = performance.now();
    if (this.#isAsked) this.#lines.update();
    else this.#lines.updateGhosts();
    this.#inFileUnits();
    this.#stand()?.show(this.#lines);
    this.#stage.requestRender();
    const { cost } = this.#world.registry.get(debugging);
    cost.add(start);
    cost.note();
  }

  /** Whether a collection asks for it; bodies do for their ghosts alone. */
  get #isAsked(): boolean {
    const { registry, collections } = this.#world;
    const effect = registry.get(debugging);
    return [...collections].some(({ node }) => node && effect.isNeededBy(node));
  }

  #inFileUnits(): void {
    const length = this.#stage.readPage()?.units.length ?? 1;
    if (length === 1) return;
    const { positions, count } = this.#lines;
    for (let i = 0; i < 6 * count; i++) positions[i] /= length;
  }

  #stand(): LineShape | undefined {
    const { document } = this.#stage;
    if (document !== this.#document) {
      this.#document = document;
      this.#shape = document && new LineShape(document);
    }
    return this.#shape;
  }

  remove(): void {
    this.#shape?.remove();
    this.#lines.dispose();
    this.#stage.requestRender();
  }
}

export const makeSketch = async (stage: Stage, world: PageWorld): Promise<Sketch> =>
  new Sketch(stage, world, await debugLines(world));
