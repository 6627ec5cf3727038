import { awaitAttempt, engine, stopAwaiting, type Engine } from './engine.js';
import { attribute, isInline, subtree } from '../words/dom.js';
import { faultsFor } from '../words/faults.js';
import { loadFailed } from '../words/load-failed.js';
import type { SceneWorld } from './scene-world.js';
import type { Scene } from './scene.js';
import { nodeOf, x3dom, type X3DElement } from '../x3dom/x3dom.js';

/** A world starts at the latest this long after its `<x3d>` was found, milliseconds. */
const LATEST = 10_000;
/** How often the document is looked at meanwhile, milliseconds. */
const INTERVAL = 20;

/** Problems that are over once the engine is there. */
const OVERCOME = ['waiting-for-engine', 'engine-load-failed'];

/** Waits until everything in the markup of an `<x3d>` is there, then has its worlds take their first step. */
export class Start {
  readonly #scene: Scene;
  readonly #settledInlines: WeakSet<Element>;
  #since: number | undefined;
  #timer: ReturnType<typeof setTimeout> | undefined;
  #engine: Engine | undefined;
  #loading = false;
  #over = false;

  constructor(scene: Scene, settledInlines: WeakSet<Element>) {
    this.#scene = scene;
    this.#settledInlines = settledInlines;
    // What comes in the same batch is built in one go.
    scene.worlds.onmake(() => queueMicrotask(() => this.#startWorlds()));
    this.check();
  }

  stop(): void {
    stopAwaiting(this.load);
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
    const waits = this.#pendingInlines().map((inline) => `Inline ${attribute(inline, 'url')}`);
    return this.#scene.unread.pending ? [...waits, 'its code'] : waits;
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
      this.#scene.tree.addInline(inline);
      return false;
    }
    const loads = attribute(inline, 'load')?.trim().toLowerCase() !== 'false';
    return loads && !!attribute(inline, 'url')?.trim() && !this.#settledInlines.has(inline);
  }

  #reportWaits(waits: string[]): void {
    const [world] = this.#scene.worlds.all;
    // Without physics nothing starts.
    if (!world) return;
    const faults = faultsFor(this.#scene.x3d, () => this.#reportWaits(waits));
    if (faults) world.report(faults.late(waits.join(', ')), this.#scene.x3d);
  }

  // ---- the engine -----------------------------------------------------------------------------------------------

  /** The first physics element of the page has the engine loaded. */
  async #loadIfNeeded(): Promise<void> {
    if (this.#scene.worlds.all.size === 0) return;
    await this.load();
  }

  readonly load = async (): Promise<void> => {
    if (this.#engine || this.#loading) return;
    this.#loading = true;
    for (const world of this.#scene.worlds.all) world.lifecycle.ready.await();
    const slow = setTimeout(() => this.#reportSlow(), LATEST);
    try {
      this.#engine = await engine();
      this.#startWorlds();
    } catch (error) {
      for (const world of this.#scene.worlds.all) this.#fail(world, error);
    } finally {
      clearTimeout(slow);
      this.#loading = false;
    }
  };

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
      for (const { element } of [{ element: this.#scene.x3d }, ...world.collections])
        for (const code of OVERCOME) world.settle(element, undefined, code);
      if (!world.started) world.start(this.#engine);
    }
  }

  #fail(world: SceneWorld, error: unknown): void {
    const what = error instanceof Error ? error.message : error;
    const report = loadFailed('engine', 'the physics engine', what);
    const [collection] = world.collections;
    const element = collection?.element ?? this.#scene.x3d;
    world.report(report, element);
    world.lifecycle.ready.reject({ ...report, element });
    awaitAttempt(this.load);
  }
}
