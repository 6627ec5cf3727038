import type { PageWorld } from '../../nodes/surroundings.js';
import { loadFailed } from '../../words/load-failed.js';
import type { Stage } from '../stage.js';
import type { DraggableBody } from '../body.js';
import type { Hands } from './hands.js';

/** Which bodies of a scene may be dragged. What people drag them with is loaded with the first. */
export class Draggables {
  readonly #stage: Stage;
  readonly bodies = new Set<DraggableBody>();
  readonly #changed = new Set<DraggableBody>();
  #hands: Hands | undefined;
  #loading = false;

  constructor(stage: Stage) {
    this.#stage = stage;
  }

  listen(world: PageWorld): void {
    world.on('draggable', (body) => this.#noteChange(body as DraggableBody));
  }

  /** A world that starts again makes all of its bodies anew: in the end nothing has changed. */
  #noteChange(body: DraggableBody): void {
    if (this.#changed.size === 0) queueMicrotask(() => this.#update());
    this.#changed.add(body);
  }

  #update(): void {
    const changed = [...this.#changed];
    this.#changed.clear();
    for (const body of changed) {
      if (body.offered === this.bodies.has(body)) continue;
      if (body.offered) this.bodies.add(body);
      else this.bodies.delete(body);
      if (body.offered) this.#hands?.add(body);
      else this.#hands?.remove(body);
    }
    if (this.bodies.size > 0) void this.#load();
    else this.destroy();
  }

  async #load(): Promise<void> {
    if (this.#hands || this.#loading) return;
    this.#loading = true;
    try {
      const { Hands } = await import('./hands.js');
      if (this.bodies.size === 0 || !this.#stage.live) return;
      this.#hands = new Hands(this.#stage);
      for (const body of this.bodies) this.#hands.add(body);
    } catch (error) {
      this.#reportMissing(error);
    } finally {
      this.#loading = false;
    }
  }

  #reportMissing(error: unknown): void {
    const [body] = this.bodies;
    const report = loadFailed('drag', 'what bodies are dragged with', error);
    body?.report({ ...report, attribute: 'draggableBody' });
  }

  destroy(): void {
    this.#hands?.destroy();
    this.#hands = undefined;
  }
}
