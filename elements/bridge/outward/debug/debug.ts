import { debugging } from '../../../../physics-core/inside.js';
import type { PageWorld } from '../../nodes/surroundings.js';
import { loadFailed } from '../../words/load-failed.js';
import type { Stage } from '../stage.js';
import type { Sketch } from './sketch.js';

/** The worlds of an `<x3d>` that are drawn as Bullet has them. What draws is loaded with the first of them. */
export class Debug {
  readonly #stage: Stage;
  readonly #sketches = new Map<PageWorld, Sketch>();

  constructor(stage: Stage) {
    this.#stage = stage;
  }

  /** The first of a world asks for it, a collection or a body with a ghost, or the last one no longer does. */
  listen(world: PageWorld): void {
    world.on('debug', (on) => {
      if (on) this.#begin(world).catch((error: unknown) => reportMissing(world, error));
      else this.#end(world);
    });
  }

  async #begin(world: PageWorld): Promise<void> {
    const { makeSketch } = await import('./sketch.js');
    const sketch = await makeSketch(this.#stage, world);
    // It may have been switched off and on meanwhile.
    if (!world.registry.active(debugging) || this.#sketches.has(world)) return sketch.remove();
    this.#sketches.set(world, sketch);
    world.work();
  }

  #end(world: PageWorld): void {
    this.#sketches.get(world)?.remove();
    this.#sketches.delete(world);
  }

  /** In every frame: what was drawn is of the frame before. */
  draw(world: PageWorld): void {
    this.#sketches.get(world)?.draw();
  }
}

function reportMissing(world: PageWorld, error: unknown): void {
  world.report(
    { ...loadFailed('debug', 'the debug drawing', error), attribute: 'debug' },
    world.registry.find(debugging)?.because?.node.host,
  );
}
