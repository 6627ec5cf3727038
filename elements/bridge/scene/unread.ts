import type { ProblemReport } from '../../../physics-core/inside.js';
import type { Readers } from '../scopes/readers.js';
import type { Scope } from '../scopes/scope.js';
import { loadFailed } from '../words/load-failed.js';
import { dropped, lacks, learnShapes } from '../x3dom/shapes/shapes.js';
import type { X3DDocument } from '../x3dom/x3dom.js';
import { isLate, particleTags } from './late-tags.js';

interface Scene {
  readonly document: X3DDocument | undefined;
  readonly readers: Readers;
  readonly scopes: { around(element: Element): Scope | undefined };
  readonly tree: { connect(root: Element, scope: Scope): void };
  noteFault(element: Element, say: () => ProblemReport): void;
}

/** Tags whose code comes in a chunk: what they are is known once it is there, to us and to x3dom. */
export class Unread {
  readonly #scene: Scene;
  readonly #met = new Set<Element>();
  /** The code is on its way. */
  pending = false;

  constructor(scene: Scene) {
    this.#scene = scene;
  }

  add(element: Element): void {
    if (!lacks(element) && !isLate(element)) return;
    this.#met.add(element);
    if (!this.pending) void this.#learn();
  }

  async #learn(): Promise<void> {
    this.pending = true;
    // What comes in the same task goes the same way.
    await undefined;
    const met = [...this.#met];
    this.#met.clear();
    if (met.some(lacks)) await learnShapes();
    if (met.some(isLate)) await particleTags.load().catch((error) => this.#fail(met, error));
    this.pending = false;
    for (const element of met) this.#show(element);
    if (this.#met.size > 0) void this.#learn();
  }

  /** One of them says it for all. */
  #fail(met: Element[], error: unknown): void {
    const report = loadFailed('particles', 'what reads particle systems', error);
    this.#scene.noteFault(met.find(isLate)!, () => report);
  }

  #show(element: Element): void {
    const { document, readers, scopes, tree } = this.#scene;
    const scope = scopes.around(element);
    if (scope && dropped(element)) document?.onNodeAdded(element, element.parentElement!);
    // A node of ours now, or a stranger for good.
    if (scope) tree.connect(element, scope);
    for (const reader of readers.of(element)) reader.dirty();
  }
}
