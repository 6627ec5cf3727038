import { loadEngine } from '../../physics-core/index.js';
import { attribute, isInline, isPhysics, subtree } from './document/dom.js';
import type { Scene } from './scene.js';
import { nodeOf, x3dom, type X3DElement } from './x3dom/x3dom.js';

/** A world starts at the latest this long after its `<x3d>` was found, milliseconds. */
const LATEST = 10_000;
/** How often the document is looked at meanwhile, milliseconds. */
const INTERVAL = 20;

type Engine = Awaited<ReturnType<typeof loadEngine>>;

let loading: Promise<Engine> | undefined;

/** The engine is fetched when the first physics element appears, once per page. */
function engine(): Promise<Engine> {
  loading ??= loadEngine();
  return loading;
}

/** Waits until everything in the markup of an `<x3d>` is there, then has its worlds take their first step. */
export class Start {
  readonly #scene: Scene;
  readonly #settledInlines: WeakSet<Element>;
  #since: number | undefined;
  #timer: ReturnType<typeof setTimeout> | undefined;
  #engine: Engine | undefined;
  #failed: unknown;
  #over = false;

  constructor(scene: Scene, settledInlines: WeakSet<Element>) {
    this.#scene = scene;
    this.#settledInlines = settledInlines;
    const listen = scene.worlds.onmake;
    scene.worlds.onmake = (world) => {
      listen(world);
      if (this.#failed) world.fail(this.#failed);
      // What comes in the same batch is built in one go.
      else queueMicrotask(() => this.#startWorlds());
    };
    this.check();
  }

  stop(): void {
    clearTimeout(this.#timer);
    this.#over = true;
  }

  /** Looks again; goes on looking until the scene is live. */
  readonly check = (): void => {
    if (this.#over) return;
    clearTimeout(this.#timer);
    // The page tells when a scene tag comes.
    if (!this.#scene.root) return;
    this.#since ??= performance.now();
    const waits = this.#waits();
    const late = performance.now() - this.#since > LATEST;
    if (waits.length > 0 && !late) {
      this.#timer = setTimeout(this.check, INTERVAL);
      return;
    }
    this.#over = true;
    this.#scene.goLive();
    if (waits.length > 0) this.#reportWaits(waits);
    this.#loadIfNeeded();
  };

  /** What has to come before the nodes are made. */
  #waits(): string[] {
    if (document.readyState === 'loading') return ['the document'];
    if (!this.#isRead(this.#scene.x3d)) return ['x3dom'];
    this.#scene.readPage();
    return this.#pendingInlines().map((inline) => `Inline ${attribute(inline, 'url')}`);
  }

  /** Without x3dom, or where it finds no WebGL, the simulation runs unseen. */
  #isRead(x3d: Element): boolean {
    if (this.#scene.document) return true;
    if (document.readyState !== 'complete') return false;
    const { hasRuntime, runtime } = x3d as X3DElement;
    return !x3dom() || (hasRuntime !== undefined && !runtime);
  }

  #pendingInlines(): Element[] {
    const pending: Element[] = [];
    if (!this.#scene.document) return pending;
    for (const scope of [...this.#scene.scopes]) {
      for (const element of subtree(scope.root)) {
        if (isInline(element) && this.#isPending(element)) pending.push(element);
      }
    }
    return pending;
  }

  #isPending(inline: Element): boolean {
    const node = nodeOf(inline);
    if (!node || node._childNodes.length > 0) {
      this.#scene.addInline(inline);
      return false;
    }
    const loads = attribute(inline, 'load')?.trim().toLowerCase() !== 'false';
    return loads && !!attribute(inline, 'url')?.trim() && !this.#settledInlines.has(inline);
  }

  #reportWaits(waits: string[]): void {
    this.#scene.worlds.default.report(
      {
        code: 'waiting-for-document',
        severity: 'warning',
        value: waits.join(', '),
        message: `the simulation starts without waiting longer for ${waits.join(', ')}`,
      },
      this.#scene.x3d,
    );
  }

  // ---- the engine -----------------------------------------------------------------------------------------------

  /** The first physics element of the page has the engine loaded. */
  async #loadIfNeeded(): Promise<void> {
    if (this.#scene.worlds.all.size === 0) return;
    await this.load();
  }

  async load(): Promise<void> {
    if (this.#engine || this.#failed) return;
    const slow = setTimeout(() => this.#reportSlow(), LATEST);
    try {
      this.#engine = await engine();
      this.#startWorlds();
    } catch (error) {
      this.#fail(error);
    } finally {
      clearTimeout(slow);
    }
  }

  #reportSlow(): void {
    const report = {
      code: 'waiting-for-engine',
      severity: 'info' as const,
      message: `the physics engine is still on its way after ${LATEST / 1000} s`,
    };
    for (const world of this.#scene.worlds.all) world.report(report, this.#scene.x3d);
  }

  #startWorlds(): void {
    if (!this.#scene.live) return;
    if (!this.#engine) return void this.load();
    this.#scene.drain();
    for (const world of this.#scene.worlds.all) {
      world.settle(this.#scene.x3d, undefined, 'waiting-for-engine');
      if (!world.started) world.start(this.#engine);
    }
  }

  #fail(error: unknown): void {
    for (const world of this.#scene.worlds.all) {
      const problem = {
        code: 'engine-load-failed',
        severity: 'error' as const,
        value: String(error),
        message: `the physics engine could not be loaded: ${String(error)}`,
      };
      const [collection] = world.collections;
      const element = collection?.element ?? this.#scene.x3d;
      world.report(problem, element);
      this.#failed = { ...problem, element };
      world.fail(this.#failed);
    }
  }
}

export const hasPhysics = (root: Element): boolean => {
  for (const element of subtree(root)) if (isPhysics(element)) return true;
  return false;
};

/** Begins fetching while the rest of the page is still read. */
export function prefetchEngine(): void {
  engine().catch(() => {});
}
