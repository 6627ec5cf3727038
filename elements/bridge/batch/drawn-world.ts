import type { EffectReport } from '../../../physics-core/inside.js';
import type { Binding } from '../nodes/binding.js';
import type { PageWorld, WorldDrawing } from '../nodes/surroundings.js';
import { LEAST } from './least.js';

/** A body, and how each of its Transforms is drawn: with how many, itself among them, or by itself for which reason. */
export interface DrawnBody {
  body: Binding;
  batch: object | undefined;
  size: number;
  why: string | undefined;
}

/** What is drawn, and what it costs. */
export interface Drawn {
  readonly bytes: number;
  /** Milliseconds per frame. */
  readonly ms: number;
  /** Batches with bodies of a world, and how many draws those save. */
  count(world: PageWorld): { batches: number; drawsSaved: number };
  bodies(): Iterable<DrawnBody>;
  of(body: Binding): DrawnBody | undefined;
}

const REASON = `${LEAST} bodies and more look alike`;

/** What one world can say of how its bodies are drawn. */
export class DrawnWorld implements WorldDrawing {
  readonly #drawn: Drawn;
  readonly #world: PageWorld;

  /** What the world says of itself has this beside it from now on. */
  constructor(drawn: Drawn, world: PageWorld) {
    this.#drawn = drawn;
    this.#world = world;
    const above = Object.getPrototypeOf(world) as PageWorld;
    const own = <Name extends 'stats' | 'effects'>(name: Name): PageWorld[Name] =>
      Reflect.get(above, name, world) as PageWorld[Name];
    Object.defineProperties(world, {
      stats: { get: () => ({ ...own('stats'), ...this.stats }) },
      effects: { get: () => [...own('effects'), ...this.effects] },
    });
  }

  #batched(): DrawnBody[] {
    const all = [...this.#drawn.bodies()];
    return all.filter(({ body, batch }) => batch && body.world === this.#world);
  }

  get stats() {
    return this.#drawn.count(this.#world);
  }

  get effects(): EffectReport[] {
    const elements = this.#batched().map(({ body }) => body.element);
    const [element] = elements;
    const { bytes, ms } = this.#drawn;
    return [
      {
        name: 'batched drawing',
        active: elements.length > 0,
        because: element ? { element, reason: REASON } : null,
        elements,
        ms: element ? ms : 0,
        calls: element ? 1 : 0,
        chunk: 'batch-code',
        bytes,
      },
    ];
  }

  explain(body: Binding): string | undefined {
    const drawn = this.#drawn.of(body);
    if (!drawn) return undefined;
    if (drawn.batch) return `in one call with ${drawn.size - 1} others that look alike`;
    return `by itself: ${drawn.why ?? `fewer than ${LEAST} look alike and stand in one group`}`;
  }
}
