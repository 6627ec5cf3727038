import { guards } from '../../base/guards.js';
import { HeapExhausted } from '../../engine/exhausted.js';
import type { PhysicsNode } from '../../nodes/node/node.js';
import { show } from '../../base/show.js';
import type { NodeWorld } from '../../nodes/node/node-world.js';

/** Share of the heap limit from which an author is warned. */
const HEAP_LOW = 0.9;

const DEFAULT_HEAP = 512 * 2 ** 20;

const megabytes = (bytes: number): number => Math.round(bytes / 2 ** 20);

/** How large the wasm heap may grow. Past the limit nothing is made any more; shortly before it authors are warned. */
export class HeapLimit {
  readonly #world: NodeWorld;
  readonly #pause: () => void;
  readonly #most: number;
  /** What found no room; one of them is told of. */
  readonly #leftOut = new Set<PhysicsNode>();
  #told: PhysicsNode | undefined;
  /** The limit then, bytes. */
  #limit = 0;

  constructor(world: NodeWorld, pause: () => void, maxHeapBytes = DEFAULT_HEAP) {
    this.#world = world;
    this.#pause = pause;
    this.#most = maxHeapBytes > 0 ? maxHeapBytes : this.#refuse(maxHeapBytes);
  }

  #refuse(value: unknown): number {
    this.#world.report({
      code: 'bad-value',
      severity: 'warning',
      attribute: 'maxHeapBytes',
      value,
      used: DEFAULT_HEAP,
      message: `maxHeapBytes takes a number above 0, not ${show(value)}; ${DEFAULT_HEAP} is used`,
    });
    return DEFAULT_HEAP;
  }

  get #bytes(): number {
    const { settings } = this.#world;
    return settings.authored('heapLimit')
      ? settings.asked<number>('heapLimit') * 2 ** 20
      : this.#most;
  }

  /** Before something is made. */
  check(): void {
    if (!guards.roomy(this.#world.engine.heapBytes, this.#bytes)) throw new HeapExhausted();
  }

  /** The addition is undone, and the world pauses; the page lives. However many are left out, one of them is told of. */
  exhausted(node: PhysicsNode): void {
    this.#pause();
    this.#leftOut.add(node);
    this.#limit = this.#bytes;
    if (this.#told && this.#leftOut.has(this.#told) && !this.#told.removed) return;
    this.#told = node;
    this.#world.report(
      {
        code: 'heap-exhausted',
        severity: 'error',
        used: 'paused world',
        message: `the wasm heap, which may grow to ${megabytes(this.#bytes)} MB, has no room for ${node.label}; it and whatever finds none after it are left out, and the world pauses`,
      },
      node,
    );
  }

  /** There was room for one that had been left out: there may be for the others. */
  made(node: PhysicsNode): void {
    if (this.#leftOut.delete(node)) this.#retry();
  }

  #retry(): void {
    const others = [...this.#leftOut];
    this.#leftOut.clear();
    this.#told?.settle(undefined, 'heap-exhausted');
    this.#told = undefined;
    for (const other of others) if (!other.removed) this.#world.store.changed(other);
  }

  /** While the world runs. */
  watch(): void {
    if (this.#leftOut.size > 0 && this.#bytes > this.#limit) this.#retry();
    const { heapBytes } = this.#world.engine;
    if (heapBytes < this.#bytes * HEAP_LOW) return;
    this.#world.report({
      code: 'heap-low',
      severity: 'warning',
      value: heapBytes,
      message: `the wasm heap has taken ${megabytes(heapBytes)} MB of the ${megabytes(this.#bytes)} MB it may`,
    });
  }
}
